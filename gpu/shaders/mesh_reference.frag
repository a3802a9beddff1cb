#version 450 core
// A reference view: colour, and disparity for reprojecting it.
layout(binding = 2) uniform sampler2D colorImage;
layout(location = 0) in vec2 source;
layout(location = 1) in float disparity;
layout(location = 0) out vec4 color;
layout(location = 1) out float reference;

void main() {
    color = vec4(texture(colorImage, source).rgb, 1.0);
    reference = disparity;
}
