#version 450 core
// Each sub-pixel takes its colour channel from the tile of the view that its lens sends where that
// view belongs. Phase in wrapping fixed point: 2^32 = one cycle.
layout(std140, binding = 2) uniform InterleaverBlock {
    uvec4 fan;   // views, 1 if the vendor's order is reversed
    ivec4 tiles; // columns; tile width, height
    ivec4 panel; // width, height
};

layout(binding = 0) uniform sampler2D atlas;
layout(binding = 1) uniform usampler2D columnPhases; // R, G, B of each column
layout(binding = 2) uniform usampler2D rowPhases;    // top row first

layout(location = 0) out vec4 color;

int viewOf(uint phase) {
    uint view, fraction;
    umulExtended(phase, fan.x, view, fraction);
    return int(fan.y != 0u ? fan.x - 1u - view : view);
}

// The panel pixel's centre in its view's tile; never reads a neighbouring tile.
float sampleTile(int view, ivec2 pixel, int channel) {
    ivec2 origin = ivec2(view % tiles.x, view / tiles.x) * tiles.yz;
#ifdef NEAREST
    ivec2 texel = (2 * pixel + 1) * tiles.yz / (2 * panel.xy);
    return texelFetch(atlas, origin + texel, 0)[channel];
#else
    ivec2 last = tiles.yz - 1;
    vec2 position = (vec2(pixel) + 0.5) * vec2(tiles.yz) / vec2(panel.xy) - 0.5;
    ivec2 low = ivec2(floor(position));
    vec2 weight = position - vec2(low);
    ivec2 a = clamp(low, ivec2(0), last), b = clamp(low + 1, ivec2(0), last);
    float bottom = mix(texelFetch(atlas, origin + a, 0)[channel],
                       texelFetch(atlas, origin + ivec2(b.x, a.y), 0)[channel], weight.x);
    float top = mix(texelFetch(atlas, origin + ivec2(a.x, b.y), 0)[channel],
                    texelFetch(atlas, origin + b, 0)[channel], weight.x);
    return mix(bottom, top, weight.y);
#endif
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy); // y up
    uint row = texelFetch(rowPhases, ivec2(panel.y - 1 - pixel.y, 0), 0).x;
    uvec3 phases = texelFetch(columnPhases, ivec2(pixel.x, 0), 0).xyz + row;
    color = vec4(sampleTile(viewOf(phases.x), pixel, 0), sampleTile(viewOf(phases.y), pixel, 1),
                 sampleTile(viewOf(phases.z), pixel, 2), 1.0);
}
