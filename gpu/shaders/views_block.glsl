// Shared by everything that draws mesh layers; twin of ViewsBlock.
layout(std140, binding = 1) uniform ViewsBlock {
    ivec4 tiles; // columns, rows of the atlas; view (one pass per view); width of the layer's grid
    vec4 range;  // nearest drawable z (m), start and length of the layer's share of the depth range
};
