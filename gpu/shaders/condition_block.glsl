// Shared by the passes of DepthConditioner; twin of gpu::ConditionBlock. A pixel between them is
// one number: its count (0: no measurement), its sigma in 1/16 counts, and whether it flies. All is
// whole numbers, so that every driver decides alike and nothing can be infinite or undefined.
layout(std140, binding = 5) uniform ConditionBlock {
    uvec4 valid;   // nearest, farthest count; weakest, saturated amplitude
    uvec4 surface; // step per pixel in 1/4096 of the depth, edge in 1/16 sigma, widest hole, table row
    uvec4 hold;    // gate in 1/16 sigma, frames to settle, frames to keep, drift in 1/16 sigma
};

const uint kFlying = 0x80000000u;

uint pixelOf(uint count, uint sigma) { return count | sigma << 16; }
uint countOf(uint pixel) { return pixel & 0xffffu; }
uint sigmaOf(uint pixel) { return (pixel & 0x7fffffffu) >> 16; }
bool isUsable(uint pixel) { return countOf(pixel) != 0u && (pixel & kFlying) == 0u; }

uint apart(uint a, uint b) { return max(a, b) - min(a, b); }

// Whether two measurements so many pixels apart can be of one surface: the step between them is
// within their noise, or no steeper than the limit. At most 2^16 * 2^12 * 9: it fits.
bool areOneSurface(uint a, uint b, uint pixels) {
    uint step = apart(countOf(a), countOf(b));
    uint nearer = min(countOf(a), countOf(b));
    return step <= max(nearer * surface.x * pixels >> 12,
                       surface.y * (sigmaOf(a) + sigmaOf(b)) >> 9);
}
