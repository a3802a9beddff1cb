// Triangles that are not drawn though a corner was measured: number of the cell times two, plus
// one for the second triangle. register_mesh.comp lists them, indirect dispatches work them off.
layout(std430, binding = 0) buffer CutTriangles {
    uint groups, groupsY, groupsZ; // of glDispatchComputeIndirect
    uint cuts;
    uint cutTriangles[];
};
const uint kCutsPerGroup = 64u;
