#version 450 core
// Depths of what the panel shows, counted in bins of equal ratio: all of it, then its central third;
// twin of calib::DepthHistogram. Of large grids every second node in each direction is enough.
layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D points; // u, v, disparity, z of the depth grid's mesh
layout(std430, binding = 1) buffer Bins { uint bins[]; };

const float kNearest = 0.05;
const float kBinsPerOctave = 64.0;
const int kBins = 704;

int binOf(float z) { return clamp(int(floor(log2(z / kNearest) * kBinsPerOctave)), 0, kBins - 1); }

bool isWithin(vec2 place, float low, float high) {
    return all(greaterThanEqual(place, vec2(low))) && all(lessThanEqual(place, vec2(high)));
}

void main() {
    ivec2 size = textureSize(points, 0);
    ivec2 node = ivec2(gl_GlobalInvocationID.xy) * (size.x > 256 ? 2 : 1);
    if (any(greaterThanEqual(node, size))) return;
    vec4 point = texelFetch(points, node, 0);
    if (point.w <= 0.0 || !isWithin(point.xy, 0.0, 1.0)) return;
    int bin = binOf(point.w);
    atomicAdd(bins[bin], 1u);
    if (isWithin(point.xy, 1.0 / 3.0, 2.0 / 3.0)) atomicAdd(bins[kBins + bin], 1u);
}
