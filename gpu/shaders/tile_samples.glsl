// What a view shows at a place of the panel, from its tile of the atlas. Needs interleaver_block.glsl.
layout(binding = 0) uniform sampler2D atlas;

// Lower left texel of a view's tile. Division by the atlas' columns as a product, because whole
// division is slow where the GPU is a CPU; exact for views up to 1000 in up to 100 columns.
ivec2 tileOrigin(int view) {
    int row = int((uint(view) * atlasRow.x) >> 20);
    return ivec2(view - row * tiles.x, row) * tiles.yz;
}

// One channel of view `view` at `place` (texels of its tile, the first centre at 0.5); never reads a
// neighbouring tile.
float sampleView(int view, vec2 place, int channel) {
    ivec2 origin = tileOrigin(view);
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

// Where a pixel (from the bottom left) of a panel that the whole picture fills lies in every tile:
// texels, or the one texel.
#ifdef NEAREST
#define Place ivec2
ivec2 placeOf(ivec2 pixel) {
    // floor((2 pixel + 1) tile / (2 panel)): a guess in float, made exact in whole numbers.
    ivec2 texel = ivec2((vec2(pixel) + 0.5) * scale.xy);
    ivec2 rest = (2 * pixel + 1) * tiles.yz - texel * (2 * panel.xy);
    return texel + ivec2(greaterThanEqual(rest, 2 * panel.xy)) - ivec2(lessThan(rest, ivec2(0)));
}
float samplePlace(int view, ivec2 texel, int channel) {
    return texelFetch(atlas, tileOrigin(view) + texel, 0)[channel];
}
#else
#define Place vec2
vec2 placeOf(ivec2 pixel) { return (vec2(pixel) + 0.5) * scale.xy; }
float samplePlace(int view, vec2 place, int channel) { return sampleView(view, place, channel); }
#endif

// At a share of the view's width and height.
float sampleShare(int view, vec2 share, int channel) {
    vec2 texel = share * vec2(tiles.yz);
#ifdef NEAREST
    texel = floor(texel) + 0.5;
#endif
    return sampleView(view, texel, channel);
}
