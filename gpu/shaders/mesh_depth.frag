#version 450 core
layout(location = 0) in float depth;
layout(location = 0) out float metres;

void main() { metres = depth; }
