// What an eye sees through the panel: x = X - (e_x - X) Z / (e_z - Z), and so for y; for the fan's
// eyes that is u - b d (calib::DisparityLaw). Needs scene_block.glsl.
layout(binding = 2) uniform sampler2D eyes; // of each view, left to right; metres

vec3 eyeOf(int view) { return texelFetch(eyes, ivec2(view, 0), 0).xyz; }

vec4 seenFrom(vec3 eye, vec3 place) {
    float z = place.z * form.z;
    // What reaches the eye is cut off. Heights are subtracted from each other, not from the eye's, so
    // that the depth test tells flattened ones apart.
    float top = min(range.x, 0.98 * eye.z);
    return vec4((place.xy * eye.z - eye.xy * z) / form.xy,
                (top - z) * (eye.z - range.y) / (top - range.y), eye.z - z);
}

vec4 inTile(vec4 seen, int view) {
    vec2 tile = vec2(view % viewTiles.x, view / viewTiles.x);
    vec2 place = (0.5 * (seen.xy + seen.w) + tile * seen.w) / vec2(viewTiles.xy);
    return vec4(2.0 * place - seen.w, seen.zw);
}

// Distances to a view's four edges, positive inside.
vec4 insideView(vec4 seen) {
    return vec4(seen.w + seen.x, seen.w - seen.x, seen.w + seen.y, seen.w - seen.y);
}
