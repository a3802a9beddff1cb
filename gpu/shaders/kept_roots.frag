#version 450 core
// The panel's colours from what its sub-pixels have found.
#include "interleaver_block.glsl"
#include "searched_samples.glsl"

layout(binding = 13) uniform usampler2D roots;

layout(location = 0) out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy); // y up
#ifdef UPSIDE_DOWN
    Place shown = placeOf(ivec2(pixel.x, panel.y - 1 - pixel.y));
#else
    Place shown = placeOf(pixel);
#endif
    uvec3 found = unpackRoots(texelFetch(roots, pixel, 0).xy);
    color = vec4(sampleRoot(found.x, shown, 0), sampleRoot(found.y, shown, 1),
                 sampleRoot(found.z, shown, 2), 1.0);
    color.rgb *= fade(pixel);
}
