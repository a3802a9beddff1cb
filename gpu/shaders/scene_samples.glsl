// What a view shows at a place of the panel, found in a scene's reference viewpoints and lit there:
// no view is ever drawn. Unlit without PER_PIXEL. Needs interleaver_block.glsl.
#define PARTS_UNIT 11
#include "scene_block.glsl"
#include "scene_parts.glsl"
#include "scene_light.glsl"
#include "scene_surfaces.glsl"
#include "scene_search.glsl"
#include "scene_seen.glsl"
#include "scene_fill.glsl"

struct Place {
    vec2 uv;
    int row;
};

Place placeAt(vec2 uv) {
    return Place(uv, clamp(int(floor(uv.y * float(lattice.z))), 0, lattice.z - 1));
}

Place placeOf(ivec2 pixel) { return placeAt((vec2(pixel) + 0.5) * fine.xy); }

// What neither reference sees, between the ends of the gap as this eye sees them (Eq. 5).
Surface acrossGap(Found found, float x, float b, int row) {
    float reach = (b - positionOfReference(found.reference)) * float(lattice.x - 2 * lattice.y);
    float halfStep = 0.5 * float(found.edge - found.behind);
    Surface behind = surfaceAt(found.reference, float(found.behind) + 0.5, row);
    Surface edge = surfaceAt(found.reference, float(found.edge) + 0.5, row);
    float from = float(found.behind) + 0.5 + halfStep - reach * behind.disparity;
    float to = float(found.edge) + 0.5 - halfStep - reach * edge.disparity;
    float at = x + float(lattice.y);
    return between(behind, edge, clamp((at - from) / (to - from), 0.0, 1.0));
}

// What an eye at position b sees there.
float sampleEye(float b, Place place, int channel) {
    vec2 uv = place.uv + vec2(float(channel - 1) * fine.z, 0.0);
    float x = uv.x * float(lattice.x - 2 * lattice.y);
    Found found = searchReferences(x, b, place.row);
    Surface surface = nothing();
    if (found.isGap)
        surface = acrossGap(found, x, b, place.row);
    else
        surface = surfaceAt(found.reference, found.x, place.row);
    float light = surface.diffuse[channel];
#ifdef PER_PIXEL
    vec2 here = lightAt(placeOfSurface(uv, b, surface.disparity), normalize(surface.normal),
                        eyeAt(b), surface.shininess, channel);
    light = light * here.x + surface.specular[channel] * here.y;
#endif
    vec3 shown = onScreen(vec3(light + surface.emissive[channel]));
    return surface.cover > 0.0 ? mix(backdrop[channel], shown.x, surface.cover) : backdrop[channel];
}

float samplePlace(int view, Place place, int channel) {
    return sampleEye(positionOf(view), place, channel);
}

// At a share of the view's width and height.
float sampleShare(int view, vec2 share, int channel) {
    return samplePlace(view, placeAt(share), channel);
}
