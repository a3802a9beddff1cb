#version 450 core
// Raw counts -> what counts as a measurement, and how sure it is.
#include "condition_block.glsl"
#include "condition_tally.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform usampler2D depthCounts;
layout(binding = 1) uniform usampler2D amplitudes; // one 0 where there are none
layout(binding = 2) uniform usampler2D sigmas;     // 1/16 counts; row 0: by count, 1: by amplitude
layout(r32ui, binding = 0) uniform writeonly uimage2D measured;

// Sixteen bins an octave; below sixteen every number has its own.
int binOf(uint number) {
    if (number < 16u) return int(number);
    int octave = findMSB(number);
    return (octave - 3) * 16 + int(number >> (octave - 4) & 15u);
}

uint measure(ivec2 pixel) {
    uint count = texelFetch(depthCounts, pixel, 0).x;
    if (count == 0u || count == 65535u) {
        tally(kMissing);
        return 0u;
    }
    uint amplitude = texelFetch(amplitudes, min(pixel, textureSize(amplitudes, 0) - 1), 0).x;
    if (count < valid.x || count > valid.y || amplitude < valid.z || amplitude >= valid.w) {
        tally(kRejected);
        return 0u;
    }
    ivec2 bin = surface.w == 1u ? ivec2(binOf(amplitude), 1) : ivec2(binOf(count), 0);
    uint sigma = texelFetch(sigmas, bin, 0).x;
    if (sigma * 100u > count * 16u) tally(kDoubtful); // more than 1 % of the range
    return pixelOf(count, sigma);
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(measured)))) return;
    imageStore(measured, pixel, uvec4(measure(pixel)));
}
