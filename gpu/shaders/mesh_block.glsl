// Shared by the passes that build mesh layers; twin of gpu::MeshBlock.
layout(std140, binding = 0) uniform MeshBlock {
    mat4 colorFromDepth;
    vec4 colorPinhole; // fx fy cx cy, pixels
    vec4 colorSize;    // width, height, metric radius squared
    vec4 colorRadial;  // k1 k2 k3 p1
    vec4 colorRational; // k4 k5 k6 p2
    vec4 framing;      // left, bottom, width, height on the upright z = 1 plane
    vec4 upright;      // columns of the matrix from the camera's rays to upright ones
    vec4 grid;         // columns, rows of the cyclopean grid; its margins (panel widths, heights)
    vec4 law;          // focus, scale, viewer distance (m), Bx (panel widths)
    vec4 budget;       // farthest, nearest (panel widths), metres per count, cut (m; 0: none)
    uvec4 counts;      // nearest, farthest count, cut in permille
};

const float kNoRay = 1e29; // rays beyond it: the pixel has no direction

// Ray (x/z, y/z) of the colour camera -> place on the panel, and back; twins of calib::Framing's.
vec2 panelFromRay(vec2 ray) {
    vec2 turned = mat2(upright.xy, upright.zw) * ray;
    return vec2(turned.x - framing.x, framing.y - turned.y) / framing.zw;
}
vec2 rayFromPanel(vec2 uv) {
    vec2 turned = vec2(framing.x + uv.x * framing.z, framing.y - uv.y * framing.w);
    return turned * mat2(upright.xy, upright.zw); // its transpose is its inverse
}

// Stands for whatever lies beyond the cut, or has no depth at all where there is a cut.
const float kBackdrop = 1000.0; // m; farther than any measurement
bool isBackdrop(float z) { return z >= kBackdrop; }
float orBackdrop(float z) {
    return budget.w > 0.0 && (z == 0.0 || z > budget.w) ? kBackdrop : z;
}

bool isMeasured(uint count) { return count >= counts.x && count <= counts.y; }

// Nearer and farther than the cut allows, in whole numbers: every device decides alike.
bool isCut(uint nearer, uint farther) { return (farther - nearer) * 1000u > counts.z * nearer; }
