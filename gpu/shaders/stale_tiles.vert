#version 450 core
// A square of the panel an instance, as a strip of two triangles.
#include "interleaver_block.glsl"
#include "stale_tiles.glsl"

void main() {
    int square = int(staleSquares[gl_InstanceID]), across = tilesAcross(panel.x);
    ivec2 tile = ivec2(square % across, square / across) + ivec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(vec2(tile * kTile) * fine.xy * 2.0 - 1.0, 0.0, 1.0);
}
