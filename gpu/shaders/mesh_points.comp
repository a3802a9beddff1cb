#version 450 core
// Every node of a layer's grid, once for all views: where it stands in the cyclopean picture,
// its disparity and depth, and where the colour image sees it. z = 0: no node. PLACES: only
// what the registration needs.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "color_camera.glsl"
#include "disparity.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D rays; // x/z, y/z of each depth pixel
#ifdef BACKGROUND
layout(binding = 1) uniform usampler2D samples; // count, source pixel x, y
#else
layout(binding = 1) uniform usampler2D depthCounts;
#endif
#ifdef PLACES
layout(rgba32f, binding = 0) uniform writeonly image2D places; // texture coordinate, z, count
#define NODES places
#else
layout(rgba32f, binding = 0) uniform writeonly image2D points; // u, v, disparity, z
layout(rg32f, binding = 1) uniform writeonly image2D sources;  // texture coordinate
#define NODES points
#endif

vec2 rayOf(ivec2 pixel) { return texelFetch(rays, pixel, 0).xy; }
bool hasRay(ivec2 pixel) { return rayOf(pixel).x < kNoRay; }

void main() {
    ivec2 node = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(node, imageSize(NODES)))) return;
#ifdef BACKGROUND
    uvec4 chosen = texelFetch(samples, node, 0);
    uint count = chosen.x;
    ivec2 source = ivec2(chosen.yz);
    ivec2 pixel = min(node * BACKGROUND, textureSize(rays, 0) - 1);
    bool usable = count > 0u && hasRay(pixel) && hasRay(source);
#else
    uint count = texelFetch(depthCounts, node, 0).x;
    ivec2 source = node;
    ivec2 pixel = node;
    bool usable = isMeasured(count) && hasRay(pixel);
#endif
    float z = float(count) * budget.z;
    vec3 point = usable ? inColorCamera(rayOf(pixel), z) : vec3(0.0);
    vec3 seen = usable ? inColorCamera(rayOf(source), z) : vec3(0.0);
    usable = point.z > 0.0 && isSeen(seen);
#ifdef PLACES
    imageStore(places, node, usable ? vec4(sourceOf(seen), seen.z, float(count)) : vec4(0.0));
#else
    if (!usable) {
        imageStore(points, node, vec4(0.0));
        imageStore(sources, node, vec4(0.0));
        return;
    }
    vec2 ray = point.xy / point.z;
    vec2 uv = vec2(ray.x - framing.x, framing.y - ray.y) / framing.zw;
    imageStore(points, node, vec4(uv, disparityAt(point.z, law, budget.xy), point.z));
    imageStore(sources, node, vec4(sourceOf(seen), 0.0, 0.0));
#endif
}
