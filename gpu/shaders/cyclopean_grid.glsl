// The grid over the cyclopean view; twin of calib::CyclopeanGrid. Needs mesh_block.glsl, camera.glsl.
vec2 panelFromTexel(vec2 texel) {
    vec2 share = (texel + 0.5) / grid.xy;
    return vec2(share.x, 1.0 - share.y) * (1.0 + 2.0 * grid.zw) - grid.zw;
}

const vec2 kNoSource = vec2(-1.0);

// Where the colour camera sees a place of the panel: it stands in the cyclopean view's place.
vec2 sourceFromPanel(vec2 uv) {
    vec2 ray = rayFromPanel(uv);
    if (dot(ray, ray) > colorSize.z) return kNoSource;
    vec2 pixel = distortRay(ray, colorRadial, colorRational) * colorPinhole.xy + colorPinhole.zw;
    return textureFromPixel(pixel, colorSize.xy);
}

bool isInPicture(vec2 source) {
    return all(greaterThanEqual(source, vec2(0.0))) && all(lessThanEqual(source, vec2(1.0)));
}

// Farther than the cut allows.
bool isBehind(float z, float nearer) { return z > nearer * (1.0 + float(counts.z) * 0.001); }
