// Which pixel of which view a fragment of the atlas is. Needs scene_block.glsl, scene_surfaces.glsl.
struct TilePixel {
    int view; // negative: none
    ivec2 inside, origin;
};

TilePixel tilePixel() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 size = ivec2(lattice.x - 2 * lattice.y, lattice.z);
    ivec2 tile = pixel / size;
    int view = tile.y * viewTiles.x + tile.x;
    bool isView = tile.x < viewTiles.x && view < viewTiles.w;
    return TilePixel(isView ? view : -1, pixel - tile * size, tile * size);
}
