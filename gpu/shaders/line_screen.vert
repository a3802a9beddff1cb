#version 450 core
// The opaque lines of a barrier as an eye sees them on the panel, a strip of four corners a line
// from the panel's lower edge to its upper one (Kooima 2007, section 2.3). Black.
layout(std140, binding = 6) uniform LineScreenBlock {
    vec4 edges; // clip x of the first line's left edge below and above; from line to line; width
    vec4 depth; // x: in the depth buffer
};

void main() {
    int end = gl_VertexID >> 1, side = gl_VertexID & 1;
    float x = edges[end] + float(gl_InstanceID) * edges.z + float(side) * edges.w;
    gl_Position = vec4(x, 2 * end - 1, depth.x, 1.0);
}
