#version 450 core
// Marks flying pixels: a mixture of two surfaces stands between a nearer and a farther neighbour,
// and next to nobody. Whoever has two neighbours on its own surface stays: of the eight around it a
// plane, however slanted, has two that are seen within 22.5 degrees of its line of equal depth, and
// a wire has two along itself. Mixtures of one edge may resemble each other; run again, the pass
// no longer lets marked ones speak for a neighbour, so that short rows of them go from their ends.
#include "condition_block.glsl"
#include "condition_tally.glsl"
#include "listed_blocks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform usampler2D measured;
layout(r32ui, binding = 0) uniform writeonly uimage2D marked;
layout(r8ui, binding = 1) uniform writeonly uimage2D flying; // blocks with any

const uint kEnough = 2u; // neighbours on the same surface

// Those to the sides first: almost everywhere they settle it.
const ivec2 kAround[8] = ivec2[](ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1),
                                 ivec2(-1, -1), ivec2(1, -1), ivec2(-1, 1), ivec2(1, 1));

bool flies(ivec2 pixel, uint own) {
    ivec2 last = textureSize(measured, 0) - 1;
    bool nearer = false, farther = false;
    uint supporters = 0u;
    for (int i = 0; i < 8 && supporters < kEnough; ++i) {
        ivec2 at = pixel + kAround[i];
        if (at != clamp(at, ivec2(0), last)) continue;
        uint other = texelFetch(measured, at, 0).x;
        if (countOf(other) == 0u) continue;
        if (areOneSurface(own, other, 1u)) {
            if (isUsable(other)) ++supporters;
        } else if (countOf(other) < countOf(own)) {
            nearer = true;
        } else {
            farther = true;
        }
    }
    return nearer && farther && supporters < kEnough;
}

void main() {
    ivec2 pixel = listedTexel();
    if (any(greaterThanEqual(pixel, imageSize(marked)))) return;
    uint own = texelFetch(measured, pixel, 0).x;
    if (isUsable(own) && flies(pixel, own)) {
        own |= kFlying;
        tally(kFlyingRemoved);
        imageStore(flying, listedBlock(), uvec4(1u));
    }
    imageStore(marked, pixel, uvec4(own));
}
