// Shared by the passes that build mesh layers; twin of gpu::MeshBlock.
layout(std140, binding = 0) uniform MeshBlock {
    mat4 colorFromDepth;
    vec4 colorPinhole; // fx fy cx cy, pixels
    vec4 colorSize;    // width, height, metric radius squared
    vec4 colorRadial;  // k1 k2 k3 p1
    vec4 colorRational; // k4 k5 k6 p2
    vec4 framing;      // left, bottom, width, height on the z = 1 plane
    vec4 grid;         // columns, rows of the cyclopean grid; its margins (panel widths, heights)
    vec4 law;          // focus, scale, viewer distance (m), Bx (panel widths)
    vec4 budget;       // farthest, nearest (panel widths), metres per count
    uvec4 counts;      // nearest, farthest count, cut in permille
};

const float kNoRay = 1e29; // rays beyond it: the pixel has no direction

bool isMeasured(uint count) { return count >= counts.x && count <= counts.y; }

// Nearer and farther than the cut allows, in whole numbers: every device decides alike.
bool isCut(uint nearer, uint farther) { return (farther - nearer) * 1000u > counts.z * nearer; }
