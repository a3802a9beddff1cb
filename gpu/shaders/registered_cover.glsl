// Draws into the picture of keys; corners are x, y (pixels, centres at one half) and 1/z, which is
// linear on the picture, so that depth is perspective-correct.
layout(r32ui, binding = 0) uniform uimage2D keys;

struct Triangle {
    vec2 origin;
    vec2 toB, toC; // weights of corners b and c, per pixel from the origin
    vec3 inverseZ; // at the origin, and what b and c add to it
    vec2 limits;   // least and most 1/z: of slivers, a thousandth of a pixel beside is far away
    vec3 slack;    // least weights inside
};

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

Triangle triangleOf(vec3 a, vec3 b, vec3 c) {
    vec2 ab = b.xy - a.xy, ac = c.xy - a.xy;
    float area = cross2(ab, ac);
    Triangle result;
    result.origin = a.xy;
    result.toB = vec2(ac.y, -ac.x) / area;
    result.toC = vec2(-ab.y, ab.x) / area;
    result.inverseZ = vec3(a.z, b.z - a.z, c.z - a.z);
    result.limits = vec2(min(a.z, min(b.z, c.z)), max(a.z, max(b.z, c.z)));
    // A pixel on a common edge belongs to both triangles, whatever the rounding says.
    const float kEdge = 0.001; // pixels
    vec2 b1 = abs(result.toB), c1 = abs(result.toC);
    vec2 slack = -kEdge * vec2(b1.x + b1.y, c1.x + c1.y);
    result.slack = vec3(slack.x + slack.y, slack);
    if (area == 0.0) result.slack = vec3(2.0); // nothing is inside
    return result;
}

// 1/z of the triangle at a pixel, 0 outside.
float inverseZAt(Triangle triangle, vec2 pixel) {
    vec2 at = pixel - triangle.origin;
    vec2 weights = vec2(dot(triangle.toB, at), dot(triangle.toC, at));
    bool inside = 1.0 - weights.x - weights.y >= triangle.slack.x &&
                  all(greaterThanEqual(weights, triangle.slack.yz));
    float inverseZ = triangle.inverseZ.x + dot(weights, triangle.inverseZ.yz);
    return inside ? clamp(inverseZ, triangle.limits.x, triangle.limits.y) : 0.0;
}

// First and last pixel whose centre lies in a box.
ivec4 pixelsIn(vec2 least, vec2 most) {
    vec2 size = vec2(imageSize(keys));
    return ivec4(ceil(max(least, vec2(0.0)) - 0.5), floor(min(most, size) - 0.5));
}

// Two triangles with the edge b c in common.
void cover(vec3 a, vec3 b, vec3 c, vec3 d, bool measured) {
    Triangle one = triangleOf(a, b, c), two = triangleOf(d, b, c);
    ivec4 box = pixelsIn(min(min(a.xy, b.xy), min(c.xy, d.xy)),
                         max(max(a.xy, b.xy), max(c.xy, d.xy)));
    for (int y = box.y; y <= box.w; ++y)
        for (int x = box.x; x <= box.z; ++x) {
            vec2 pixel = vec2(x, y) + 0.5;
            float inverseZ = max(inverseZAt(one, pixel), inverseZAt(two, pixel));
            if (inverseZ > 0.0)
                imageAtomicMax(keys, ivec2(x, y),
                               measured ? measuredKey(inverseZ) : extrudedKey(inverseZ));
        }
}
