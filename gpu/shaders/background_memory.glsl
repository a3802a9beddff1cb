// What background_remember.comp remembers; needs cyclopean_grid.glsl.
layout(binding = 5) uniform sampler2D memoryDepth; // m; 0: nothing
layout(binding = 6) uniform sampler2D memoryColor; // alpha: trust

// Something remembered that stands behind a surface at z now.
bool isRemembered(ivec2 texel, float z) {
    float kept = texelFetch(memoryDepth, texel, 0).x;
    return z > 0.0 && kept > 0.0 && isBehind(kept, z) && texelFetch(memoryColor, texel, 0).a >= 0.25;
}
