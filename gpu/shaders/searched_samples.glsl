// What a view shows at a place of the panel, found in the layers themselves: no view is ever drawn.
// Needs interleaver_block.glsl.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "cyclopean_grid.glsl"
#include "layer_search.glsl"
#include "first_hit.glsl"
#include "root.glsl"

layout(binding = 11) uniform sampler2D colors[2];     // the scene's picture, the background's
layout(binding = 10) uniform sampler2D viewPositions; // b of each view, left to right

// A place of the panel with all that its three channels share: reading uniforms within loops is dear
// where the GPU is a CPU.
struct Place {
    Row row;
    float texel;         // of the grid, from its left edge
    float texelsPerWidth, texelsPerChannel;
    vec2 ray, rayPerTexel; // at the grid's left edge
    vec4 pinhole, radial, rational; // the colour camera, pinhole to texture coordinates
    float radius;        // metric, squared
    vec2 background;     // texture coordinates: per texel across; down
};

Place placeAt(vec2 uv) {
    vec2 spread = 1.0 + 2.0 * grid.zw;
    float texels = grid.x / spread.x;
    float y = clamp((1.0 + grid.w - uv.y) / spread.y * grid.y, 0.0, grid.y - 1e-3);
    vec2 left = rayFromPanel(vec2(-grid.z, uv.y)), right = rayFromPanel(vec2(1.0 + grid.z, uv.y));
    Place place;
    place.row = Row(int(y), int(grid.y), int(grid.x) - 1, fract(y), budget.x, budget.y);
    place.texel = (uv.x + grid.z) * texels;
    place.texelsPerWidth = texels;
    place.texelsPerChannel = fine.z * texels;
    place.ray = left;
    place.rayPerTexel = (right - left) / grid.x;
    place.pinhole = vec4(colorPinhole.xy, colorPinhole.zw + 0.5) / colorSize.xyxy;
    place.radial = colorRadial;
    place.rational = colorRational;
    place.radius = colorSize.z;
    place.background = vec2(1.0, y) / grid.xy;
    return place;
}

Place placeOf(ivec2 pixel) { return placeAt((vec2(pixel) + 0.5) * fine.xy); }

// Where a layer's picture shows what is `hit` texels from the grid's left edge.
vec2 sourceOf(Place place, int layer, float hit) {
    vec2 ray = place.ray + hit * place.rayPerTexel;
    vec2 source = distortRay(ray, place.radial, place.rational) * place.pinhole.xy + place.pinhole.zw;
    if (dot(ray, ray) > place.radius) source = kNoSource;
    return layer == 0 ? source : vec2(hit * place.background.x, place.background.y);
}

// What an eye at position b sees there.
uint findRoot(float b, Place place, int channel) {
    float x = place.texel + float(channel - 1) * place.texelsPerChannel;
    float reach = b * place.texelsPerWidth;
    uint root = kBlackRoot;
    for (int layer = 0; layer < 2; ++layer) {
        float hit = firstHit(place.row, layer, x, reach);
        if (hit < 0.0 && layer == 0) continue;
        root = rootOf(hit * place.background.x, layer);
        break;
    }
    return root;
}

// One channel of it. A loop that ends as soon as the layer is the right one for all: where the GPU is
// a CPU, both sides of a branch cost.
float sampleRoot(uint root, Place place, int channel) {
    float hit = shareOf(root) * float(place.row.lastColumn + 1);
    float value = 0.0;
    for (int layer = 0; layer < 2; ++layer) {
        value = textureLod(colors[layer], sourceOf(place, layer, hit), 0.0)[channel];
        if (layer == layerOf(root)) break;
    }
    return root == kBlackRoot ? 0.0 : value;
}

// Both at once and without rounding: for two tracked eyes a quarter quicker than one after the other.
float sampleEye(float b, Place place, int channel) {
    float x = place.texel + float(channel - 1) * place.texelsPerChannel;
    float reach = b * place.texelsPerWidth;
    float value = 0.0;
    for (int layer = 0; layer < 2; ++layer) {
        float hit = firstHit(place.row, layer, x, reach);
        if (hit < 0.0 && layer == 0) continue;
        value = textureLod(colors[layer], sourceOf(place, layer, hit), 0.0)[channel];
        break;
    }
    return value;
}

float positionOf(int view) { return texelFetch(viewPositions, ivec2(view, 0), 0).x; }

float samplePlace(int view, Place place, int channel) {
    return sampleEye(positionOf(view), place, channel);
}

// At a share of the view's width and height.
float sampleShare(int view, vec2 share, int channel) {
    return samplePlace(view, placeAt(share), channel);
}
