// Where the mesh's nodes lie on the cyclopean grid, in texels; needs mesh_block.glsl.
vec2 texelFromPanel(vec2 uv) {
    vec2 place = (uv + grid.zw) / (1.0 + 2.0 * grid.zw);
    return vec2(place.x, 1.0 - place.y) * grid.xy;
}

const float kSnap = 1.0 / 16.0; // of a texel: rasterisers round to less

// First and last block of the grid that something between `low` and `high` may cover; none: the first
// is after the last.
ivec4 blocksBetween(vec2 low, vec2 high) {
    if (any(greaterThan(low, grid.xy + 1.0)) || any(lessThan(high, vec2(-1.0)))) return ivec4(1, 1, 0, 0);
    vec2 last = grid.xy - 1.0;
    return ivec4(clamp(low - kSnap, vec2(0.0), last), clamp(high + kSnap, vec2(0.0), last)) / 8;
}
