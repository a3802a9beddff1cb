// Shared by everything that fills the panel; twin of InterleaverBlock.
layout(std140, binding = 2) uniform InterleaverBlock {
    uvec4 fan;   // views; 1: tiles from the top; start and width of lit bands, 1: tiles swapped
    ivec4 tiles; // columns of the atlas; tile width, height
    ivec4 panel; // width, height; rows after which column phases repeat; eyes or panel tiles across
    vec4 edge;   // 1 / pixels of fade at the border; negative lobe; grey: screen, gain
    vec4 scale;  // per pixel of the panel, x and y: texels of a tile
    vec4 fine;   // search: panel per pixel, x and y; from a channel to the next, panel widths
    vec4 rig;    // search: b at phase 0, b per 2^-32 cycle
    uvec4 atlasRow; // 2^20 / columns of the atlas, rounded up
};

// Towards black over the outermost pixels.
float fade(ivec2 pixel) {
#ifndef FRINGE
    return 1.0;
#endif
    ivec2 inside = min(pixel, panel.xy - 1 - pixel);
    return min((float(min(inside.x, inside.y)) + 0.5) * edge.x, 1.0);
}
