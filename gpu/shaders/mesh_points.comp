#version 450 core
// Every node of the depth grid, once for all views: where it stands in the cyclopean picture,
// its disparity and depth, and where the colour image sees it. z = 0: no node. PLACES: only
// what the registration needs.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "color_camera.glsl"
#include "disparity.glsl"

#ifdef PLACES
layout(local_size_x = 16, local_size_y = 16) in;

ivec2 ownNode() { return ivec2(gl_GlobalInvocationID.xy); }
#else
#include "listed_blocks.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

ivec2 ownNode() { return listedTexel(); }
#endif

layout(binding = 0) uniform sampler2D rays; // x/z, y/z of each depth pixel
layout(binding = 1) uniform usampler2D depthCounts;
#ifdef PLACES
layout(rgba32f, binding = 0) uniform writeonly image2D places; // texture coordinate, z, count
#define NODES places
#else
layout(rgba32f, binding = 0) uniform writeonly image2D points; // u, v, disparity, z
layout(rg32f, binding = 1) uniform writeonly image2D sources;  // texture coordinate
#define NODES points
#endif

void main() {
    ivec2 node = ownNode();
    if (any(greaterThanEqual(node, imageSize(NODES)))) return;
    uint count = texelFetch(depthCounts, node, 0).x;
    vec2 ray = texelFetch(rays, node, 0).xy;
    bool usable = isMeasured(count) && ray.x < kNoRay;
    vec3 point = usable ? inColorCamera(ray, float(count) * budget.z) : vec3(0.0);
    usable = isSeen(point);
#ifdef PLACES
    imageStore(places, node, usable ? vec4(sourceOf(point), point.z, float(count)) : vec4(0.0));
#else
    if (!usable) {
        imageStore(points, node, vec4(0.0));
        imageStore(sources, node, vec4(0.0));
        return;
    }
    vec2 uv = panelFromRay(point.xy / point.z);
    imageStore(points, node, vec4(uv, disparityAt(point.z, law, budget.xy), point.z));
    imageStore(sources, node, vec4(sourceOf(point), 0.0, 0.0));
#endif
}
