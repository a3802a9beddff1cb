#version 450 core
// A piece of the panel an instance, as a strip of two triangles.
#include "interleaver_block.glsl"
#include "stale_tiles.glsl"

layout(std430, binding = 2) readonly buffer DrawnTiles {
    TileList drawn;
    uint drawnTiles[]; // row by row from the top left
};

void main() {
    int number = int(drawnTiles[gl_InstanceID]), across = tilesAcross(panel.x);
    ivec2 tile = ivec2(number % across, number / across) + ivec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(vec2(tile * kTile) * fine.xy * 2.0 - 1.0, 0.0, 1.0);
}
