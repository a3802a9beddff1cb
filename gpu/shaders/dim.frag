#version 450 core
// What is drawn here is multiplied with what was there, by the blending of gpu/dimmer.cpp.
layout(location = 0) out vec4 color;

void main() {
    color = vec4(1.0);
}
