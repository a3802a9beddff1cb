#version 450 core
// Whole views in tiles of the panel: half frames and quilts. What floor(panel / count) leaves over
// at the right, and opposite the first row of tiles, stays black.
#include "interleaver_block.glsl"
#ifdef SURFACES
#include "scene_samples.glsl"
#elif defined(SEARCH)
#include "searched_samples.glsl"
#else
#include "tile_samples.glsl"
#endif

layout(location = 0) out vec4 color;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy); // y up
    ivec2 size = panel.xy / panel.wz;
    // Rows of tiles are counted from the top for half frames, from the bottom for quilts.
    bool topFirst = fan.y != 0u;
    ivec2 place = topFirst ? ivec2(pixel.x, panel.y - 1 - pixel.y) : pixel;
    ivec2 tile = place / size;
    int view = tile.y * panel.w + tile.x;
    color = vec4(0.0, 0.0, 0.0, 1.0);
    if (tile.x >= panel.w || tile.y >= panel.z || view >= int(fan.x)) return;
    if (fan.z != 0u) view = int(fan.x) - 1 - view;
    vec2 inside = vec2(place - tile * size) + 0.5;
    if (topFirst) inside.y = float(size.y) - inside.y;
    for (int channel = 0; channel < 3; ++channel)
        color[channel] = sampleShare(view, inside / vec2(size), channel);
}
