#version 450 core
// Each sub-pixel takes its colour channel from the tile of the view that its lens sends where that
// view belongs. Phase in wrapping fixed point: 2^32 = one cycle.
#include "interleaver_block.glsl"
#ifdef SURFACES
#include "scene_samples.glsl"
#elif defined(SEARCH)
#include "searched_samples.glsl"
#else
#include "tile_samples.glsl"
#endif

#include "affine_phase.glsl"
#include "grid_phase.glsl"

#if defined(LUT) || defined(PATTERN)
layout(binding = 1) uniform usampler2D phaseTable; // top row first
#endif
#ifdef REMAP
layout(binding = 6) uniform usampler2D remap; // view from the left of each vendor's view, or black
const uint kBlack = 0xffffu;
#endif

#ifdef ROOTS
layout(location = 0) out uvec2 roots; // for kept_roots.frag
#else
layout(location = 0) out vec4 color;
#endif

// From the top left.
uvec3 phasesAt(ivec2 place) {
#if defined(LUT)
    return texelFetch(phaseTable, place, 0).xyz;
#elif defined(PATTERN)
    return texelFetch(phaseTable, ivec2(place.x, place.y % panel.z), 0).xyz;
#else
    return affinePhases(0, uvec2(place)) + gridPhase(place);
#endif
}

uint viewOf(uint vendor) {
#ifdef REMAP
    return texelFetch(remap, ivec2(vendor, 0), 0).x;
#elif defined(REVERSED)
    return fan.x - 1u - vendor;
#else
    return vendor;
#endif
}

#ifdef ROOTS
uint subpixelRoot(uint cycles, Place place, int channel) {
#ifdef CONTINUOUS
    float b = clamp(rig.x + rig.y * float(cycles), -1.0, 1.0);
#else
    uint vendor, fraction;
    umulExtended(cycles, fan.x, vendor, fraction);
    uint view = viewOf(vendor);
#ifdef REMAP
    if (view == kBlack) return kBlackRoot;
#endif
    float b = positionOf(int(view));
#endif
    return findRoot(b, place, channel);
}
#else
float show(uint vendor, Place place, int channel) {
    uint view = viewOf(vendor);
#ifdef REMAP
    if (view == kBlack) return 0.0;
#endif
    return samplePlace(int(view), place, channel);
}

float subpixel(uint cycles, Place place, int channel) {
#ifdef CONTINUOUS
    return sampleEye(clamp(rig.x + rig.y * float(cycles), -1.0, 1.0), place, channel);
#else
    uint vendor, fraction;
    umulExtended(cycles, fan.x, vendor, fraction);
#ifdef BLEND
    // Towards the next view over a view's own interval; the last one has none: it does not wrap.
    uint next = min(vendor + 1u, fan.x - 1u);
    return mix(show(vendor, place, channel), show(next, place, channel),
               float(fraction >> 8) / 16777216.0);
#else
    return show(vendor, place, channel);
#endif
#endif
}
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy); // y up
    ivec2 place = ivec2(pixel.x, panel.y - 1 - pixel.y);
    uvec3 phases = phasesAt(place);
#ifdef UPSIDE_DOWN
    Place shown = placeOf(place);
#else
    Place shown = placeOf(pixel);
#endif
#ifdef ROOTS
    uvec3 found;
    for (int channel = 0; channel < 3; ++channel)
        found[channel] = subpixelRoot(phases[channel], shown, channel);
    roots = packRoots(found);
#else
#ifdef SEARCH
    // As a loop: three searches in a row take minutes to compile where the GPU is a CPU.
    color.a = 1.0;
    for (int channel = 0; channel < 3; ++channel)
        color[channel] = subpixel(phases[channel], shown, channel);
#else
    color = vec4(subpixel(phases.x, shown, 0), subpixel(phases.y, shown, 1),
                 subpixel(phases.z, shown, 2), 1.0);
#endif
    color.rgb *= fade(pixel);
#endif
}
