#version 450 core
// Every view's tile from the reference viewpoints: holes filled by what lies to their left and right
// (the super-multi-view paper, Eq. 5), then lit for the view's own eye (Eq. 6 to 10). Unlit without
// PER_PIXEL.
#include "scene_block.glsl"
#include "scene_parts.glsl"
#include "scene_light.glsl"
#include "scene_surfaces.glsl"
#include "scene_seen.glsl"
#include "scene_fill.glsl"
#include "scene_root.glsl"
#include "scene_tile.glsl"
layout(binding = 2) uniform usampler2D roots; // of scene_reproject.frag

layout(location = 0) out vec4 color;

Surface surfaceOf(uint root, int row) {
    if (root >= kNothing) return nothing();
    return surfaceAt(referenceOf(root), columnOf(root), row);
}

// Pixels from a hole to what is no hole, that way, or to the tile's border.
int wayOut(TilePixel pixel, int step, int width) {
    int at = pixel.inside.x;
    for (int left = width; left > 0; --left) {
        at += step;
        if (at < 0 || at >= width) break;
        if (texelFetch(roots, pixel.origin + ivec2(at, pixel.inside.y), 0).x != kHole) break;
    }
    return at;
}

Surface filled(TilePixel pixel) {
    int width = lattice.x - 2 * lattice.y;
    int left = wayOut(pixel, -1, width), right = wayOut(pixel, 1, width);
    if (left < 0 && right >= width) return nothing();
    // At the border both sides are the same one.
    int first = left < 0 ? right : left, second = right >= width ? left : right;
    ivec2 row = pixel.origin + ivec2(0, pixel.inside.y);
    Surface a = surfaceOf(texelFetch(roots, row + ivec2(first, 0), 0).x, pixel.inside.y);
    Surface b = surfaceOf(texelFetch(roots, row + ivec2(second, 0), 0).x, pixel.inside.y);
    float toLeft = float(pixel.inside.x - left), toRight = float(right - pixel.inside.x);
    return between(a, b, toLeft / (toLeft + toRight));
}

void main() {
    TilePixel pixel = tilePixel();
    uint root = texelFetch(roots, ivec2(gl_FragCoord.xy), 0).x;
    Surface surface = nothing();
    if (root == kHole)
        surface = filled(pixel);
    else
        surface = surfaceOf(root, pixel.inside.y);
    color = backdrop;
    if (surface.cover == 0.0) return;
    vec3 light = surface.diffuse;
#ifdef PER_PIXEL
    float b = positionOf(pixel.view);
    vec2 uv = (vec2(pixel.inside) + 0.5) / vec2(lattice.x - 2 * lattice.y, lattice.z);
    Light here = lightAt(placeOfSurface(uv, b, surface.disparity), normalize(surface.normal),
                         eyeAt(b), surface.shininess);
    light = light * here.diffuse + surface.specular * here.specular;
#endif
    color = vec4(mix(backdrop.rgb, onScreen(light + surface.emissive), surface.cover), 1.0);
}
