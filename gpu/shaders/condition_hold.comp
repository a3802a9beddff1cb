#version 450 core
// Holds every pixel's value exactly while its measurements differ by noise only, so that a still
// scene makes a still picture. What differs by more passes at once; what differs by less, but goes
// on to, is found by the mean of its residuals.
#include "condition_block.glsl"
#include "condition_tally.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform usampler2D measured;
layout(binding = 1) uniform usampler2D before; // held, 1/256 counts; frames; mean residual; sigma
layout(r32ui, binding = 0) uniform uimage2D calm;
layout(rgba32ui, binding = 1) uniform writeonly uimage2D after;
layout(r8ui, binding = 2) uniform uimage2D waited; // frames without a measurement
layout(r8ui, binding = 3) uniform writeonly uimage2D changed; // blocks of 8 x 8 of `calm`

const int kResidualShift = 4; // the mean residual forgets in 2^4 frames
const int kReach = 2;         // pixels: what misses a measurement seldom misses it alone
const uint kQuarterSigma = 4u; // sigmas are in 1/16 counts, held values in 1/256
const uint kEnough = 2u;      // pixels that make a surface, as in condition_flying

// What the noise of a measurement, and of the n frames that the held value is the mean of, can do.
// Five eighths of it while settling: a false alarm costs nothing yet, and the mean of a surface that
// moves is of none of its places.
uint gateOf(uvec4 held, uint now) {
    uint gate = hold.x * max(held.w, sigmaOf(now));
    gate += gate / (2u * held.y);
    return held.y < hold.y ? gate - 3u * gate / 8u : gate;
}

uvec4 start(uint now) { return uvec4(countOf(now) << 8, 1u, 0u, sigmaOf(now)); }

uvec4 settle(uvec4 held, uint now) {
    uint n = held.y + 1u;
    return uvec4((held.x * held.y + (countOf(now) << 8) + n / 2u) / n, n, 0u,
                 (held.w * held.y + sigmaOf(now) + n / 2u) / n);
}

uvec4 follow(uvec4 held, uint now) {
    int mean = int(held.z);
    mean += (int(countOf(now) << 8) - int(held.x) - mean) >> kResidualShift;
    if (uint(abs(mean)) <= hold.w * held.w) {
        return uvec4(held.xy, uint(mean), held.w);
    }
    tally(kCorrected);
    // The mean lags behind a drift: a quarter of the settling again takes out what it misses.
    return uvec4(uint(int(held.x) + mean), max(1u, hold.y / 4u), 0u, held.w);
}

bool isWithinGate(uvec4 held, uint now) {
    return apart(held.x, countOf(now) << 8) <= gateOf(held, now);
}

uint heldPixel(uvec4 held) { return pixelOf(held.x + 128u >> 8, held.w); }

// What the pixels around say to one without a measurement, or with another one than was held.
struct Around {
    bool still; // most of those on its surface still are where they were
    bool mixed; // its measurement lies between its surface and another one, and on neither
};

Around lookAround(ivec2 pixel, uvec4 own, uint now) {
    ivec2 last = textureSize(measured, 0) - 1;
    uint holding = 0u, changed = 0u, agreeing = 0u;
    bool between = false;
    for (int y = -kReach; y <= kReach; ++y) {
        for (int x = -kReach; x <= kReach; ++x) {
            ivec2 at = pixel + ivec2(x, y);
            if (at == pixel || at != clamp(at, ivec2(0), last)) continue;
            uint other = texelFetch(measured, at, 0).x;
            if (!isUsable(other)) continue;
            uvec4 held = texelFetch(before, at, 0);
            uint steps = uint(max(abs(x), abs(y)));
            if (held.y > 0u && areOneSurface(heldPixel(own), heldPixel(held), steps)) {
                if (isWithinGate(held, other)) ++holding;
                else ++changed;
            }
            if (areOneSurface(heldPixel(own), other, steps)) continue;
            if (!areOneSurface(other, now, steps)) {
                bool isFarther = countOf(now) << 8 > own.x;
                between = between || isFarther == (countOf(other) > countOf(now));
            } else if (held.y > 0u && areOneSurface(heldPixel(held), now, steps)) {
                ++agreeing; // it stands where something stood before
            }
        }
    }
    return Around(holding > 0u && holding >= changed, between && agreeing < kEnough);
}

// Whether a pixel without a measurement keeps its value for another frame: where the pixels around
// hold, nothing came between. Flying pixels that look like a surface are no measurement either.
bool isKept(ivec2 pixel, uvec4 held, uint now) {
    if (held.y == 0u || (isUsable(now) && isWithinGate(held, now))) return false;
    if (imageLoad(waited, pixel).x >= hold.z) return false;
    Around around = lookAround(pixel, held, now);
    return around.still && (!isUsable(now) || around.mixed);
}

uvec4 update(uvec4 held, uint now) {
    if (held.y == 0u) {
        tally(kSettling);
        return start(now);
    }
    if (!isWithinGate(held, now)) {
        tally(kPassed);
        return start(now);
    }
    if (held.y >= hold.y) return follow(held, now);
    tally(kSettling);
    return settle(held, now);
}

// While a value settles it moves every frame, by less than what it is known to: what is shown stands
// until a quarter of sigma lies between them, or it has settled.
bool isShownStill(uint shown, uvec4 held) {
    bool settling = held.y > 1u && held.y < hold.y;
    return settling && countOf(shown) != 0u &&
           apart(countOf(shown) << 8, held.x) <= kQuarterSigma * held.w;
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(pixel, imageSize(calm)))) return;
    uint now = texelFetch(measured, pixel, 0).x;
    uvec4 held = texelFetch(before, pixel, 0);
    uint frames = 0u;
    if (isKept(pixel, held, now)) {
        frames = imageLoad(waited, pixel).x + 1u;
        tally(isUsable(now) ? kMixed : kKept);
    } else {
        held = isUsable(now) ? update(held, now) : uvec4(0u);
    }
    uint last = imageLoad(calm, pixel).x;
    uint shown = held.y > 0u ? isShownStill(last, held) ? last : heldPixel(held) : 0u;
    if (shown != last) {
        imageStore(calm, pixel, uvec4(shown));
        imageStore(changed, pixel / 8, uvec4(1u));
    }
    imageStore(after, pixel, held);
    imageStore(waited, pixel, uvec4(frames));
}
