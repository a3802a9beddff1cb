// Layers laid out for the search of the first surface behind a sub-pixel: the scene's rows, then the
// background's; with the largest disparity of each block of texels in a row.
const float kNoSurface = -1e9; // disparity of a texel without depth: behind everything
const int kBlock = 4;
