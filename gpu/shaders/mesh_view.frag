#version 450 core
layout(binding = 2) uniform sampler2D colorImage;
layout(location = 0) in vec2 source;
layout(location = 0) out vec4 color;

void main() { color = vec4(texture(colorImage, source).rgb, 1.0); }
