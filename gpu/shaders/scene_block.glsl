// Shared by everything that draws scenes of triangles; twin of gpu::SceneBlock. Metres, display
// space: origin in the panel's centre, x right, y up, z toward the viewer.
layout(std140, binding = 7) uniform SceneBlock {
    ivec4 viewTiles; // columns, rows of the atlas; view, or the first of a pass; views in all
    vec4 form;   // half the panel's width and height, share of heights that is shown, lights
    vec4 range;  // nearest and farthest height that is shown; Bx (panel widths), distance D
    vec4 ambient;
    vec4 lightPlaces[8]; // where light comes from; w: 0: a direction, 1: a place
    vec4 lightColors[8]; // w: 1 / reach squared
    vec4 lightCones[8];  // along the axis of a spot light
    vec4 lightFades[8];  // cosines of where a spot light ends and where it begins to
};
