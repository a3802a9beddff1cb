// Nodes of the depth grid for the passes that draw it at the colour camera.
layout(binding = 0) uniform sampler2D places; // as mesh_points.comp has them
layout(binding = 1) uniform sampler2D rays;

struct Corner {
    vec3 place; // pixels of the result, 1/z
    uint count; // 0: not measured
    ivec2 node;
};

Corner cornerAt(ivec2 node) {
    vec4 place = texelFetch(places, node, 0);
    // So near to the colour camera, one cell would fill the picture.
    bool drawable = place.z > 0.1 * float(counts.x) * budget.z;
    return Corner(vec3(place.xy * vec2(imageSize(keys)), 1.0 / place.z),
                  drawable ? uint(place.w) : 0u, node);
}

bool isDrawn(Corner a, Corner b, Corner c) {
    uint nearest = min(a.count, min(b.count, c.count));
    return nearest > 0u && !isCut(nearest, max(a.count, max(b.count, c.count)));
}

// Ray of a node; where the lens has none there, straight on from that of the mirrored one.
vec2 rayAt(ivec2 node, ivec2 owner) {
    vec2 ray = texelFetch(rays, node, 0).xy, own = texelFetch(rays, owner, 0).xy;
    vec2 mirrored = texelFetch(rays, 2 * owner - node, 0).xy;
    return ray.x < kNoRay ? ray : mirrored.x < kNoRay ? 2.0 * own - mirrored : own;
}

// Where the colour camera sees `owner`'s surface half way between two nodes' rays.
vec3 halfWay(Corner owner, vec2 rayA, vec2 rayB) {
    vec3 point = inColorCamera(0.5 * (rayA + rayB), float(owner.count) * budget.z);
    if (!isSeen(point)) return owner.place;
    return vec3(sourceOf(point) * vec2(imageSize(keys)), 1.0 / point.z);
}
