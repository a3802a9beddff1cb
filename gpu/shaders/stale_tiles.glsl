// Squares of the panel that have to be searched anew: an indirect draw of one square each.
const int kTile = 32; // pixels

layout(std430, binding = 2) buffer StaleTiles {
    uint vertices, squares, firstVertex, firstSquare;
    uint staleSquares[]; // row by row from the top left, in squares
};

int tilesAcross(int width) { return (width + kTile - 1) / kTile; }
