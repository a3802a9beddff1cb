// Light that a surface of the reference viewpoints sends to an eye of the fan. Needs
// scene_surfaces.glsl, scene_light.glsl.
layout(binding = 10) uniform sampler2D viewPositions; // b of each view, left to right

float positionOf(int view) { return texelFetch(viewPositions, ivec2(view, 0), 0).x; }
vec3 eyeAt(float b) { return vec3(2.0 * form.x * range.z * b, 0.0, range.w); }

// Where in the scene, undistorted, what is seen at `uv` of the panel from b stands (Eq. 3).
vec3 placeOfSurface(vec2 uv, float b, float disparity) {
    float height = range.w * disparity / (range.z + disparity);
    vec2 cyclopean = 2.0 * vec2(uv.x + b * disparity, uv.y) - 1.0;
    return vec3(cyclopean * form.xy * (1.0 - height / range.w), height / form.z);
}
