#version 450 core
// Disparity in place of colour, panel widths at |b| = 1.
layout(location = 1) in float disparity;
layout(location = 0) out float value;

void main() { value = disparity; }
