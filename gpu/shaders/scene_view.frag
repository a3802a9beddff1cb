#version 450 core
// A scene's surfaces: colour, as a screen wants it; DISPARITY: where a display that makes its own
// views has to put them (panel widths); SURFACES (with DISPARITY): what a reference viewpoint keeps
// of them. TEXTURED, PER_VERTEX, PER_PIXEL: what they are made of.
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
#elif defined(PLAIN)
layout(location = 2) flat in vec3 shown;
#endif
#if defined(DISPARITY)
layout(location = 4) in float height;
layout(location = 0) out float disparity;
#endif
#if !defined(DISPARITY) || defined(SURFACES)
layout(binding = 0) uniform sampler2D surface; // sRGB; white where there is none

vec3 ownColor() {
    vec3 light = diffuseOf(numbers.x).rgb;
#ifndef PLAIN
    light *= texture(surface, uv).rgb;
#endif
    return light;
}
#endif

#if defined(SURFACES)
layout(location = 1) out uvec4 kept; // as shaders/scene_surfaces.glsl reads it

uint octahedral(vec3 direction) {
    vec3 flattened = direction / (abs(direction.x) + abs(direction.y) + abs(direction.z));
    vec2 folded = (1.0 - abs(flattened.yx)) *
                  mix(vec2(-1.0), vec2(1.0), greaterThanEqual(flattened.xy, vec2(0.0)));
    return packUnorm2x16(0.5 + 0.5 * (flattened.z < 0.0 ? folded : flattened.xy));
}

void main() {
    disparity = range.z * height / (range.w - height);
    vec3 own = ownColor();
    kept = uvec4(numbers.x + 1, 0, packHalf2x16(own.rg), packHalf2x16(vec2(own.b, 0.0)));
#if defined(PER_PIXEL)
    kept.y = octahedral(normalize(normal));
#endif
}
#elif defined(DISPARITY)
void main() { disparity = range.z * height / (range.w - height); }
#else
layout(location = 0) out vec4 color;

#if defined(PLAIN)
void main() { color = vec4(shown, 1.0); }
#else
void main() {
    vec3 light = ownColor();
#if defined(PER_PIXEL)
    Light here = lightAt(place, normalize(normal), eyeOf(numbers.y), diffuseOf(numbers.x).w);
    light = light * here.diffuse + specularOf(numbers.x) * here.specular;
#elif defined(PER_VERTEX)
    light = light * diffuseLight + specularOf(numbers.x) * specularLight;
#endif
    color = vec4(onScreen(light + emissiveOf(numbers.x)), 1.0);
}
#endif
#endif
