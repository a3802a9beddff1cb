#version 450 core
// Each sub-pixel takes its colour channel from the tile of the view that its lens sends where that
// view belongs. Phase in wrapping fixed point: 2^32 = one cycle.
#include "interleaver_block.glsl"

#ifdef LUT
layout(binding = 1) uniform usampler2D phaseLut; // top row first
#else
layout(binding = 1) uniform usampler2D columnPhases; // R, G, B of each column; a row per row class
layout(binding = 2) uniform usampler2D rowPhases;    // top row first
#endif
#ifdef GRID
layout(binding = 3) uniform usampler2D gridNodes;
layout(binding = 4) uniform usampler2D gridColumns; // node, weight in 2^-31
layout(binding = 5) uniform usampler2D gridRows;
#endif
#ifdef REMAP
layout(binding = 6) uniform usampler2D remap; // view from the left of each vendor's view, or black
const uint kBlack = 0xffffu;
#endif

layout(location = 0) out vec4 color;

#ifdef GRID
uint between(uint a, uint b, uint weight) {
    int high, low;
    imulExtended(int(b - a), int(weight), high, low);
    return a + ((uint(high) << 1) | (uint(low) >> 31));
}

uint gridPhase(ivec2 place) {
    uvec2 across = texelFetch(gridColumns, ivec2(place.x, 0), 0).xy;
    uvec2 down = texelFetch(gridRows, ivec2(place.y, 0), 0).xy;
    ivec2 first = ivec2(across.x, down.x);
    ivec2 next = min(first + 1, textureSize(gridNodes, 0) - 1);
    uint upper = between(texelFetch(gridNodes, first, 0).x,
                         texelFetch(gridNodes, ivec2(next.x, first.y), 0).x, across.y);
    uint lower = between(texelFetch(gridNodes, ivec2(first.x, next.y), 0).x,
                         texelFetch(gridNodes, next, 0).x, across.y);
    return between(upper, lower, down.y);
}
#endif

// From the top left.
uvec3 phasesAt(ivec2 place) {
#ifdef LUT
    return texelFetch(phaseLut, place, 0).xyz;
#else
#ifdef CELLS
    int rowKind = place.y % panel.z;
#else
    const int rowKind = 0;
#endif
    uvec3 phases = texelFetch(columnPhases, ivec2(place.x, rowKind), 0).xyz +
                   texelFetch(rowPhases, ivec2(place.y, 0), 0).x;
#ifdef GRID
    phases += gridPhase(place);
#endif
    return phases;
#endif
}

float show(uint vendor, ivec2 pixel, int channel) {
#ifdef REMAP
    uint view = texelFetch(remap, ivec2(vendor, 0), 0).x;
    if (view == kBlack) return 0.0;
#else
    uint view = fan.y != 0u ? fan.x - 1u - vendor : vendor;
#endif
    return samplePixel(int(view), pixel, channel);
}

float subpixel(uint phase, ivec2 pixel, int channel) {
    uint vendor, fraction;
    umulExtended(phase, fan.x, vendor, fraction);
#ifdef BLEND
    // Towards the next view over a view's own interval; the last one has none: it does not wrap.
    uint next = min(vendor + 1u, fan.x - 1u);
    return mix(show(vendor, pixel, channel), show(next, pixel, channel),
               float(fraction >> 8) / 16777216.0);
#else
    return show(vendor, pixel, channel);
#endif
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy); // y up
    ivec2 place = ivec2(pixel.x, panel.y - 1 - pixel.y);
    uvec3 phases = phasesAt(place);
    ivec2 shown = tiles.w != 0 ? place : pixel;
    color = vec4(subpixel(phases.x, shown, 0), subpixel(phases.y, shown, 1),
                 subpixel(phases.z, shown, 2), 1.0);
    color.rgb *= fade(pixel);
}
