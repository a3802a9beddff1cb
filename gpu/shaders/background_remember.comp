#version 450 core
// The farthest surface seen at each texel and its colour, gathered over time behind a camera that
// stands still. A surface seen farther off replaces what was remembered; the same is averaged; what
// stands in front changes nothing, unless the memory is too young to be trusted (an outlier).
#include "mesh_block.glsl"
#include "camera.glsl"
#include "cyclopean_grid.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D sure; // m; 0: none
layout(binding = 1) uniform sampler2D colorImage;
layout(r32f, binding = 0) uniform image2D memoryDepth;  // m; 0: nothing
layout(rgba8, binding = 1) uniform image2D memoryColor; // alpha: trust, 1/8 for each time seen
layout(std430, binding = 0) buffer Tally {
    uvec2 before; // texels compared, and of these seen farther off than remembered
    uvec2 now;
};

const float kShare = 0.25; // of the newest in the average
const float kSeen = 1.0 / 8.0;
const float kTrusted = 0.5;

// So much of the picture does not step back at once: the camera was moved.
bool cameraMoved() { return 10u * before.y > 3u * before.x; }

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(texel, imageSize(memoryDepth)))) return;
    float z = texelFetch(sure, texel, 0).x;
    float kept = cameraMoved() ? 0.0 : imageLoad(memoryDepth, texel).x;
    vec4 color = imageLoad(memoryColor, texel);
    vec2 source = sourceFromPanel(panelFromTexel(vec2(texel)));
    if (z > 0.0 && isInPicture(source)) {
        vec3 seen = texture(colorImage, source).rgb;
        bool farther = kept > 0.0 && isBehind(z, kept);
        bool nearer = kept > 0.0 && isBehind(kept, z);
        if (kept > 0.0) atomicAdd(now.x, 1u);
        if (farther) atomicAdd(now.y, 1u);
        if (kept == 0.0 || farther || (nearer && color.a < kTrusted)) {
            kept = z;
            color = vec4(seen, kSeen);
        } else if (!nearer) {
            kept = mix(kept, z, kShare);
            color = vec4(mix(color.rgb, seen, kShare), min(color.a + kSeen, 1.0));
        }
    }
    imageStore(memoryDepth, texel, vec4(kept));
    imageStore(memoryColor, texel, color);
}
