#version 450 core
// A scene's surfaces: colour, as a screen wants it; DISPARITY: where a display that makes its own
// views has to put them (panel widths). TEXTURED, PER_VERTEX, PER_PIXEL: what they are made of.
#include "scene_block.glsl"
#include "scene_parts.glsl"
#include "scene_eyes.glsl"
#include "scene_light.glsl"

layout(location = 0) in vec2 uv;
layout(location = 1) flat in ivec2 numbers;
#if defined(PER_PIXEL)
layout(location = 2) in vec3 place;
layout(location = 3) in vec3 normal;
#elif defined(PER_VERTEX)
layout(location = 2) in vec3 diffuseLight;
layout(location = 3) in vec3 specularLight;
#elif defined(DISPARITY)
layout(location = 2) in float height;
#endif

#ifdef DISPARITY
layout(location = 0) out float disparity;

void main() { disparity = range.z * height / (range.w - height); }
#else
layout(binding = 0) uniform sampler2D surface; // sRGB; white where there is none
layout(location = 0) out vec4 color;

vec3 onScreen(vec3 light) { // IEC 61966-2-1
    vec3 clamped = clamp(light, 0.0, 1.0);
    return mix(12.92 * clamped, 1.055 * pow(clamped, vec3(1.0 / 2.4)) - 0.055,
               greaterThan(clamped, vec3(0.0031308)));
}

void main() {
    vec4 own = diffuseOf(numbers.x);
    vec3 light = own.rgb;
#ifndef PLAIN
    light *= texture(surface, uv).rgb;
#endif
#if defined(PER_PIXEL)
    Light here = lightAt(place, normalize(normal), eyeOf(numbers.y), own.w);
    light = light * here.diffuse + specularOf(numbers.x) * here.specular;
#elif defined(PER_VERTEX)
    light = light * diffuseLight + specularOf(numbers.x) * specularLight;
#endif
    color = vec4(onScreen(light + emissiveOf(numbers.x)), 1.0);
}
#endif
