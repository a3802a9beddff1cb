// Shared by everything that reads tiles for the panel; twin of InterleaverBlock.
layout(std140, binding = 2) uniform InterleaverBlock {
    uvec4 fan;   // views; 1 if the vendor's order is reversed; start and width of lit bands
    ivec4 tiles; // columns of the atlas; tile width, height; 1 if the picture is upside down
    ivec4 panel; // width, height; rows after which column phases repeat; eyes or panel tiles across
    vec4 edge;   // 1 / pixels of fade at the border (0: none); negative lobe; grey: screen, gain
};

layout(binding = 0) uniform sampler2D atlas;

// One channel of view `view` at `place` (texels of its tile, the first centre at 0.5); never reads a
// neighbouring tile.
float sampleView(int view, vec2 place, int channel) {
    ivec2 origin = ivec2(view % tiles.x, view / tiles.x) * tiles.yz;
    ivec2 last = tiles.yz - 1;
    vec2 low = floor(place - 0.5), weight = place - 0.5 - low;
    ivec2 a = origin + clamp(ivec2(low), ivec2(0), last);
    ivec2 b = origin + clamp(ivec2(low) + 1, ivec2(0), last);
    float bottom = mix(texelFetch(atlas, a, 0)[channel],
                       texelFetch(atlas, ivec2(b.x, a.y), 0)[channel], weight.x);
    float top = mix(texelFetch(atlas, ivec2(a.x, b.y), 0)[channel],
                    texelFetch(atlas, b, 0)[channel], weight.x);
    return mix(bottom, top, weight.y);
}

// The same where the whole picture fills the panel: pixel from the bottom left, in whole numbers.
float samplePixel(int view, ivec2 pixel, int channel) {
#ifdef NEAREST
    ivec2 origin = ivec2(view % tiles.x, view / tiles.x) * tiles.yz;
    return texelFetch(atlas, origin + (2 * pixel + 1) * tiles.yz / (2 * panel.xy), 0)[channel];
#else
    return sampleView(view, (vec2(pixel) + 0.5) * vec2(tiles.yz) / vec2(panel.xy), channel);
#endif
}

// Towards black over the outermost pixels.
float fade(ivec2 pixel) {
    if (edge.x == 0.0) return 1.0;
    ivec2 inside = min(pixel, panel.xy - 1 - pixel);
    return min((float(min(inside.x, inside.y)) + 0.5) * edge.x, 1.0);
}
