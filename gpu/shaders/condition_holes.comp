#version 450 core
// Measurements -> clean counts; holes up to so many pixels wide are closed. Along four lines through
// the hole: where both ends are of one surface, that surface goes on between them, the narrowest
// such line speaking; where none are, the hole lies at an edge, and the farther end goes on, because
// a near surface drawn too wide hides what the farther one would show. Two surfaces are never mixed.
#include "condition_block.glsl"
#include "condition_fills.glsl"
#include "listed_blocks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform usampler2D measured;
layout(r16ui, binding = 0) uniform uimage2D clean;
layout(r8ui, binding = 1) uniform writeonly uimage2D changed;

const ivec2 kLines[4] = ivec2[](ivec2(1, 0), ivec2(0, 1), ivec2(1, 1), ivec2(1, -1));
const int kWidest = 8; // bounds the loop whatever the block says

// Steps to the first measurement that way; 0: none within the widest hole.
int stepsTo(ivec2 pixel, ivec2 direction, out uint found) {
    ivec2 last = textureSize(measured, 0) - 1;
    int widest = min(int(surface.z), kWidest);
    for (int steps = 1; steps <= widest; ++steps) {
        ivec2 at = pixel + steps * direction;
        if (at != clamp(at, ivec2(0), last)) break;
        found = texelFetch(measured, at, 0).x;
        if (isUsable(found)) return steps;
    }
    found = 0u;
    return 0;
}

uint fill(ivec2 pixel) {
    uint surfaceGap = 1000u, surfaceCount = 0u, farthest = 0u;
    for (int line = 0; line < 4; ++line) {
        uint a, b;
        uint toA = uint(stepsTo(pixel, -kLines[line], a)), toB = uint(stepsTo(pixel, kLines[line], b));
        uint gap = toA + toB;
        if (toA == 0u || toB == 0u || gap - 1u > surface.z) continue;
        farthest = max(farthest, max(countOf(a), countOf(b)));
        if (!areOneSurface(a, b, gap)) continue;
        uint between = (countOf(a) * toB + countOf(b) * toA + gap / 2u) / gap;
        if (gap > surfaceGap || (gap == surfaceGap && between < surfaceCount)) continue;
        surfaceGap = gap;
        surfaceCount = between;
    }
    return surfaceCount > 0u ? surfaceCount : farthest;
}

void main() {
    ivec2 pixel = listedTexel();
    if (any(greaterThanEqual(pixel, imageSize(clean)))) return;
    uint own = texelFetch(measured, pixel, 0).x;
    uint count = isUsable(own) ? countOf(own) : fill(pixel);
    if (!isUsable(own)) atomicAdd(fills[2u * blocks[gl_WorkGroupID.x] + (count > 0u ? 0u : 1u)], 1u);
    if (imageLoad(clean, pixel).x == count) return;
    imageStore(clean, pixel, uvec4(count));
    imageStore(changed, listedBlock(), uvec4(1u));
}
