#version 450 core
// The mesh as the colour camera sees it, one cell an invocation. A shader is faster at this than
// the rasteriser: the triangles are a few pixels large. Those that are cut are listed.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "color_camera.glsl"
#include "registered_keys.glsl"
#include "registered_cover.glsl"
#include "registered_nodes.glsl"
#include "cut_triangles.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

void listCut(uint number) {
    uint at = atomicAdd(cuts, 1u);
    cutTriangles[at] = number;
    if (at % kCutsPerGroup == 0u) atomicAdd(groups, 1u);
}

void main() {
    ivec2 cell = ivec2(gl_GlobalInvocationID.xy);
    ivec2 cells = textureSize(places, 0) - 1;
    if (any(greaterThanEqual(cell, cells))) return;
    Corner first = cornerAt(cell), across = cornerAt(cell + 1);
    Corner right = cornerAt(cell + ivec2(1, 0)), below = cornerAt(cell + ivec2(0, 1));
    bool one = isDrawn(first, below, right), two = isDrawn(across, below, right);
    // Half a cell: the other half has no area.
    vec3 a = one ? first.place : below.place, d = two ? across.place : below.place;
    if (one || two) cover(a, below.place, right.place, d, true);
    uint number = uint(cell.y * cells.x + cell.x) * 2u;
    uint either = below.count | right.count;
    if (!one && (first.count | either) > 0u) listCut(number);
    if (!two && (across.count | either) > 0u) listCut(number + 1u);
}
