// Blinn-Phong under up to eight lights, in linear light (the super-multi-view paper, Eq. 6 to 10).
// Needs scene_block.glsl.

struct Light {
    vec3 diffuse;  // times the material's own, ambient light included
    vec3 specular; // times the material's own
};

// Of light `i`, what a surface scatters and what it mirrors to the eye.
vec2 answerTo(int i, vec3 place, vec3 normal, vec3 toEye, float shininess) {
    vec3 way = lightPlaces[i].xyz - lightPlaces[i].w * place;
    vec3 toLight = normalize(way);
    float cone = smoothstep(lightFades[i].x, lightFades[i].y, dot(-toLight, lightCones[i].xyz));
    float far = 1.0 + lightPlaces[i].w * dot(way, way) * lightColors[i].w;
    float facing = dot(normal, toLight);
    float along = max(dot(normal, normalize(toLight + toEye)), 1e-6);
    return facing > 0.0 ? cone / far * vec2(facing, pow(along, shininess)) : vec2(0.0);
}

Light lightAt(vec3 place, vec3 normal, vec3 eye, float shininess) {
    Light sum = Light(ambient.rgb, vec3(0.0));
    vec3 toEye = normalize(eye - place);
    for (int i = 0; i < int(form.w); ++i) {
        vec2 answer = answerTo(i, place, normal, toEye, shininess);
        sum.diffuse += lightColors[i].rgb * answer.x;
        sum.specular += lightColors[i].rgb * answer.y;
    }
    return sum;
}

// One channel of it: diffuse, specular.
vec2 lightAt(vec3 place, vec3 normal, vec3 eye, float shininess, int channel) {
    vec2 sum = vec2(ambient[channel], 0.0);
    vec3 toEye = normalize(eye - place);
    for (int i = 0; i < int(form.w); ++i)
        sum += lightColors[i][channel] * answerTo(i, place, normal, toEye, shininess);
    return sum;
}

vec3 onScreen(vec3 light) { // IEC 61966-2-1
    vec3 clamped = clamp(light, 0.0, 1.0);
    return mix(12.92 * clamped, 1.055 * pow(clamped, vec3(1.0 / 2.4)) - 0.055,
               greaterThan(clamped, vec3(0.0031308)));
}
