// Nodes of the depth grid for the passes that draw it at the colour camera.
layout(binding = 0) uniform sampler2D points;
layout(binding = 1) uniform sampler2D sources;
layout(binding = 2) uniform usampler2D depthCounts;
layout(binding = 3) uniform sampler2D rays;

struct Corner {
    vec3 place; // pixels of the result, 1/z
    uint count; // 0: not measured
    ivec2 node;
};

Corner cornerAt(ivec2 node) {
    float z = texelFetch(points, node, 0).w;
    // So near to the colour camera, one cell would fill the picture.
    bool drawable = z > 0.1 * float(counts.x) * budget.z;
    return Corner(vec3(texelFetch(sources, node, 0).xy * vec2(imageSize(keys)), 1.0 / z),
                  drawable ? texelFetch(depthCounts, node, 0).x : 0u, node);
}

bool isDrawn(Corner a, Corner b, Corner c) {
    uint nearest = min(a.count, min(b.count, c.count));
    return nearest > 0u && !isCut(nearest, max(a.count, max(b.count, c.count)));
}

// Where the colour camera sees `owner`'s surface half way between two nodes.
vec3 halfWay(Corner owner, ivec2 a, ivec2 b) {
    vec2 rayA = texelFetch(rays, a, 0).xy, rayB = texelFetch(rays, b, 0).xy;
    vec3 point = inColorCamera(0.5 * (rayA + rayB), float(owner.count) * budget.z);
    if (max(rayA.x, rayB.x) >= kNoRay || !isSeen(point)) return owner.place;
    return vec3(sourceOf(point) * vec2(imageSize(keys)), 1.0 / point.z);
}
