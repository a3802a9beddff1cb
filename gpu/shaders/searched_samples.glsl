// What a view shows at a place of the panel, found in the layers themselves: no view is ever drawn.
// Needs interleaver_block.glsl.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "cyclopean_grid.glsl"
#include "layer_search.glsl"
#include "first_hit.glsl"

layout(binding = 11) uniform sampler2D colors[2]; // the scene's picture, the background's
layout(binding = 10) uniform sampler2D viewPositions; // b of each view, left to right

// Panel coordinates and the grid's row below them; `down` is the share of that row above.
struct Place {
    vec2 uv;
    int row;
    float down;
};

Place placeAt(vec2 uv) {
    float y = clamp((1.0 + grid.w - uv.y) / (1.0 + 2.0 * grid.w) * grid.y, 0.0, grid.y - 1e-3);
    return Place(uv, int(y), fract(y));
}

Place placeOf(ivec2 pixel) { return placeAt((vec2(pixel) + 0.5) * fine.xy); }

// One channel as an eye at position b sees it.
float sampleEye(float b, Place place, int channel) {
    float texelsPerWidth = grid.x / (1.0 + 2.0 * grid.z);
    float x = (place.uv.x + float(channel - 1) * fine.z + grid.z) * texelsPerWidth;
    float reach = b * texelsPerWidth;
    float value = 0.0;
    for (int layer = 0; layer < 2; ++layer) {
        float hit = firstHit(layer, place.row, place.down, x, reach);
        if (hit < 0.0 && layer == 0) continue;
        vec2 source = sourceFromPanel(vec2(hit / texelsPerWidth - grid.z, place.uv.y));
        if (layer == 1) source = vec2(hit, float(place.row) + place.down) / grid.xy;
        value = textureLod(colors[layer], source, 0.0)[channel];
        break;
    }
    return value;
}

float samplePlace(int view, Place place, int channel) {
    return sampleEye(texelFetch(viewPositions, ivec2(view, 0), 0).x, place, channel);
}

// At a share of the view's width and height.
float sampleShare(int view, vec2 share, int channel) {
    return samplePlace(view, placeAt(share), channel);
}
