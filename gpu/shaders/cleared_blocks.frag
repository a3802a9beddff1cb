#version 450 core
flat in ivec2 block;
layout(location = 0) out float metres;

void main() {
    if (any(notEqual(ivec2(gl_FragCoord.xy) / 8, block))) discard;
    metres = 0.0;
}
