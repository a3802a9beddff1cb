#version 450 core
// Every node of a layer's grid, once for all views: where it stands in the cyclopean picture,
// its disparity and depth, and where the colour image sees it. z = 0: no node.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "disparity.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D rays; // x/z, y/z of each depth pixel
layout(binding = 1) uniform usampler2D depthCounts;
layout(rgba32f, binding = 0) uniform writeonly image2D points; // u, v, disparity, z
layout(rg32f, binding = 1) uniform writeonly image2D sources;  // texture coordinate

vec3 inColorCamera(ivec2 pixel, float z) {
    return (colorFromDepth * vec4(vec3(texelFetch(rays, pixel, 0).xy, 1.0) * z, 1.0)).xyz;
}

bool hasRay(ivec2 pixel) { return texelFetch(rays, pixel, 0).x < kNoRay; }

void main() {
    ivec2 node = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(node, imageSize(points)))) return;
    uint count = texelFetch(depthCounts, node, 0).x;
    bool usable = isMeasured(count) && hasRay(node);
    float z = float(count) * budget.z;
    vec3 point = usable ? inColorCamera(node, z) : vec3(0.0);
    usable = point.z > 0.0 && dot(point.xy, point.xy) <= colorSize.z * point.z * point.z;
    if (!usable) {
        imageStore(points, node, vec4(0.0));
        imageStore(sources, node, vec4(0.0));
        return;
    }
    vec2 ray = point.xy / point.z;
    vec2 uv = vec2(ray.x - framing.x, framing.y - ray.y) / framing.zw;
    vec2 pixelSeen = distortRay(ray, colorRadial, colorRational) * colorPinhole.xy +
                     colorPinhole.zw;
    imageStore(points, node, vec4(uv, disparityAt(point.z, law, budget.xy), point.z));
    imageStore(sources, node, vec4(textureFromPixel(pixelSeen, colorSize.xy), 0.0, 0.0));
}
