// What a corner of a triangle hands to its pixels, in one view. PER_PIXEL, PER_VERTEX: where
// light is reckoned; else there is none. PLAIN: a part has one colour. Needs scene_parts.glsl,
// scene_eyes.glsl, scene_light.glsl.
layout(location = 0) out vec2 uv;
layout(location = 1) flat out ivec2 numbers; // part, view
#if defined(PER_PIXEL)
layout(location = 2) out vec3 place;
layout(location = 3) out vec3 normal;
#elif defined(PER_VERTEX)
layout(location = 2) out vec3 diffuseLight;
layout(location = 3) out vec3 specularLight;
#elif defined(PLAIN)
layout(location = 2) flat out vec3 shown;
#endif
#if defined(DISPARITY)
layout(location = 4) out float height;
#endif

void handOver(vec3 own, vec3 ownNormal, vec2 ownUv, int part, int view) {
    uv = ownUv;
    numbers = ivec2(part, view);
#if defined(PER_PIXEL)
    place = own;
    normal = ownNormal;
#elif defined(PER_VERTEX)
    Light light = lightAt(own, normalize(ownNormal), eyeOf(view), diffuseOf(part).w);
    diffuseLight = light.diffuse;
    specularLight = light.specular;
#elif defined(PLAIN)
    shown = onScreen(diffuseOf(part).rgb + emissiveOf(part));
#endif
#if defined(DISPARITY)
    height = own.z * form.z;
#endif
}
