#version 450 core
// The farthest surface seen at each texel and its colour, gathered over time behind a camera that
// stands still. A surface seen farther off replaces what was remembered; the same is averaged; what
// stands in front changes nothing, unless the memory is too young to be trusted (an outlier).
#include "mesh_block.glsl"
#include "camera.glsl"
#include "cyclopean_grid.glsl"
#include "listed_blocks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform sampler2D sure; // m; 0: none
layout(binding = 1) uniform sampler2D colorImage;
layout(r32f, binding = 0) uniform image2D memoryDepth;  // m; 0: nothing
layout(rgba8, binding = 1) uniform image2D memoryColor; // alpha: trust, 1/8 for each time seen
layout(r8ui, binding = 2) uniform writeonly uimage2D changed;
#include "background_tally.glsl"

const float kShare = 0.25; // of the newest in the average
const float kSeen = 1.0 / 8.0;
const float kTrusted = 0.5;

const float kSettled = 1.0 / 1024.0; // of a depth: what is as near as that stays

void main() {
    ivec2 texel = listedTexel();
    if (any(greaterThanEqual(texel, imageSize(memoryDepth)))) return;
    float z = texelFetch(sure, texel, 0).x;
    float kept = isMoved(before) ? 0.0 : imageLoad(memoryDepth, texel).x;
    vec4 color = imageLoad(memoryColor, texel);
    vec2 source = sourceFromPanel(panelFromTexel(vec2(texel)));
    if (z > 0.0 && isInPicture(source)) {
        vec3 seen = texture(colorImage, source).rgb;
        bool farther = kept > 0.0 && isBehind(z, kept);
        bool nearer = kept > 0.0 && isBehind(kept, z);
        if (kept > 0.0) atomicAdd(compared[blocks[gl_WorkGroupID.x]], 1u);
        if (farther) atomicAdd(now.y, 1u);
        if (kept == 0.0 || farther || (nearer && color.a < kTrusted)) {
            kept = z;
            color = vec4(seen, kSeen);
        } else if (!nearer) {
            if (abs(z - kept) > kSettled * z) kept = mix(kept, z, kShare);
            color = vec4(mix(color.rgb, seen, kShare), min(color.a + kSeen, 1.0));
        }
    }
    vec4 levels = round(color * 255.0);
    bool isSame = imageLoad(memoryDepth, texel).x == kept &&
                  round(imageLoad(memoryColor, texel) * 255.0) == levels;
    // What was forgotten and is as before is not settled: next time it is averaged.
    if (isMoved(before)) imageStore(changed, listedBlock(), uvec4(1u));
    if (isSame) return;
    imageStore(memoryDepth, texel, vec4(kept));
    imageStore(memoryColor, texel, levels / 255.0);
    imageStore(changed, listedBlock(), uvec4(1u));
}
