// Blinn-Phong under up to eight lights, in linear light. Needs scene_block.glsl.

struct Light {
    vec3 diffuse;  // times the material's own, ambient light included
    vec3 specular; // times the material's own
};

Light lightAt(vec3 place, vec3 normal, vec3 eye, float shininess) {
    Light sum = Light(ambient.rgb, vec3(0.0));
    vec3 toEye = normalize(eye - place);
    for (int i = 0; i < int(form.w); ++i) {
        vec3 way = lightPlaces[i].xyz - lightPlaces[i].w * place;
        vec3 toLight = normalize(way);
        float cone = smoothstep(lightFades[i].x, lightFades[i].y,
                                dot(-toLight, lightCones[i].xyz));
        float far = 1.0 + lightPlaces[i].w * dot(way, way) * lightColors[i].w;
        vec3 color = lightColors[i].rgb * cone / far;
        float facing = dot(normal, toLight);
        if (facing <= 0.0) continue;
        float along = max(dot(normal, normalize(toLight + toEye)), 1e-6);
        sum.diffuse += color * facing;
        sum.specular += color * pow(along, shininess);
    }
    return sum;
}
