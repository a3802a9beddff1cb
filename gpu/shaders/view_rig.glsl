// Points of a mesh layer in a view: x = u - b d, y unchanged (DisparityLaw). What is nearer has the
// larger disparity, and what is linear in u and v is linear in the view. Needs mesh_block.glsl,
// views_block.glsl.
layout(binding = 3) uniform sampler2D viewPositions; // b of each view, left to right

// Where a point (u, v, disparity) lies in a view, and how far behind.
vec3 placeInView(vec3 point, int view) {
    float b = texelFetch(viewPositions, ivec2(view, 0), 0).x;
    float behind = (budget.y - point.z) / max(budget.y - budget.x, 1e-9);
    // In front of an empty tile.
    float key = range.y + range.z * 0.999 * clamp(behind, 0.0, 1.0);
    return vec3(point.x - b * point.z, point.y, key);
}

vec4 onPanel(vec3 place) { return vec4(2.0 * place.xy - 1.0, place.z, 1.0); }

vec4 inTile(vec3 place, int view) {
    vec2 tile = vec2(view % tiles.x, view / tiles.x);
    return onPanel(vec3((place.xy + tile) / vec2(tiles.xy), place.z));
}

// Distances to a view's four edges, positive inside.
vec4 insideView(vec3 place) { return vec4(place.x, 1.0 - place.x, place.y, 1.0 - place.y); }
