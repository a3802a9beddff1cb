#version 450 core
// The Combiner (Kooima 2007, section 3.5) for any number of eyes: each eye's view where its band of
// the barrier or lens is lit, the maximum where bands overlap.
#include "interleaver_block.glsl"
#ifdef SURFACES
#include "scene_samples.glsl"
#elif defined(SEARCH)
#include "searched_samples.glsl"
#else
#include "tile_samples.glsl"
#endif

#define EYES 16
#include "affine_phase.glsl"
#include "grid_phase.glsl"
#ifdef WAVEFORM
layout(binding = 1) uniform sampler2D edges; // rise start, end, fall start, end; R, G, B
#endif

layout(location = 0) out vec4 color;

// How brightly an eye's view shows in a channel: 0 or 1; with a waveform 1 .. minus its lobe.
float weight(uint phase, int channel) {
#ifdef WAVEFORM
    vec4 e = texelFetch(edges, ivec2(channel, 0), 0);
    float t = float(phase >> 8) / 16777216.0;
    float rise = e.y > e.x ? clamp((t - e.x) / (e.y - e.x), 0.0, 1.0) : step(e.x, t);
    float fall = e.w > e.z ? clamp((e.w - t) / (e.w - e.z), 0.0, 1.0) : 1.0 - step(e.z, t);
    return min(rise, fall) * (1.0 + edge.y) - edge.y;
#else
    return phase - fan.z < fan.w ? 1.0 : 0.0;
#endif
}

#ifdef SEARCH
// Of each channel, the first eye after `before` that it is lit for, and how brightly; the number of
// eyes where there is none.
ivec3 litAfter(ivec3 before, ivec2 place, uint sheet, out vec3 share) {
    ivec3 lit = ivec3(panel.w);
    share = vec3(0.0);
    for (int eye = panel.w - 1; eye >= 0; --eye) {
        uvec3 cycles = affinePhases(eye, uvec2(place)) + sheet;
        vec3 bright = vec3(weight(cycles.x, 0), weight(cycles.y, 1), weight(cycles.z, 2));
        bvec3 next = bvec3(uvec3(notEqual(bright, vec3(0.0))) * uvec3(greaterThan(ivec3(eye), before)));
        lit = mix(lit, ivec3(eye), next);
        share = mix(share, bright, next);
    }
    return lit;
}
#endif

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy); // y up
    ivec2 place = ivec2(pixel.x, panel.y - 1 - pixel.y);
    Place shown = placeOf(pixel);
    vec3 brightest = vec3(0.0), lobes = vec3(0.0);
    uint sheet = gridPhase(place); // whoever looks
#ifdef SEARCH
    // A search is dear: each turn shows one eye per channel, mostly the only one.
    vec3 share;
    ivec3 eyes = litAfter(ivec3(-1), place, sheet, share);
    while (any(lessThan(eyes, ivec3(panel.w)))) {
        for (int channel = 0; channel < 3; ++channel) {
            float light = share[channel] * samplePlace(min(eyes[channel], panel.w - 1), shown, channel);
            brightest[channel] = max(brightest[channel], light);
            lobes[channel] += min(light, 0.0);
        }
        eyes = litAfter(eyes, place, sheet, share);
    }
#else
    for (int eye = 0; eye < panel.w; ++eye) {
        uvec3 cycles = affinePhases(eye, uvec2(place)) + sheet;
        for (int channel = 0; channel < 3; ++channel) {
            float share = weight(cycles[channel], channel);
            if (share == 0.0) continue;
            float light = share * samplePlace(eye, shown, channel);
            brightest[channel] = max(brightest[channel], light);
            lobes[channel] += min(light, 0.0);
        }
    }
#endif
    color = vec4(brightest + lobes, 1.0) * vec4(vec3(fade(pixel)), 1.0);
}
