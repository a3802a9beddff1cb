// Pieces of the panel that have to be filled anew: an indirect draw of one rectangle each. Wide, as
// what changes reaches along rows.
const ivec2 kTile = ivec2(64, 16); // pixels

struct TileList {
    uint vertices, tiles, firstVertex, firstTile;
};

int tilesAcross(int width) { return (width + kTile.x - 1) / kTile.x; }
