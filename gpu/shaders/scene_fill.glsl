// Holes of a view, between what lies on either side (the super-multi-view paper, Eq. 5): all that a
// pixel is lit from, nothing taken as a share of cover. Needs scene_surfaces.glsl.

Surface nothing() {
    return Surface(0.0, span.y, vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0), 0.0);
}

// `share`: 0: as the first.
Surface between(Surface a, Surface b, float share) {
    vec2 weights = vec2((1.0 - share) * a.cover, share * b.cover);
    float cover = weights.x + weights.y;
    weights /= max(cover, 1e-9);
    return Surface(cover, weights.x * a.disparity + weights.y * b.disparity,
                   weights.x * a.normal + weights.y * b.normal,
                   weights.x * a.diffuse + weights.y * b.diffuse,
                   weights.x * a.specular + weights.y * b.specular,
                   weights.x * a.emissive + weights.y * b.emissive,
                   weights.x * a.shininess + weights.y * b.shininess);
}
