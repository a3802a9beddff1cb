// Geometry buffers of a scene's reference viewpoints (the super-multi-view paper, section II A), a
// layer each; twin of gpu::SurfacesBlock. Texels are a tile's, and `lattice.y` more on either side.
// Needs scene_parts.glsl.
layout(std140, binding = 3) uniform SurfacesBlock {
    ivec4 lattice;  // texels across, of them margin on each side, rows; references
    vec4 lineup;    // b of the first one, step to the next; step in disparity that is an edge
    vec4 span;      // disparity: nearest, that of texels that show nothing (behind everything)
    vec4 backdrop;  // what is behind everything, as a screen wants it
};
layout(binding = 0) uniform sampler2DArray disparities; // panel widths at |b| = 1
layout(binding = 12) uniform sampler2DArray peaks; // of scene_peaks.comp
const int kPeakBlock = 16; // texels; as in gpu::SceneSurfaces
// Part + 1, or 0: nothing; normal, octahedral; diffuse red and green; blue.
layout(binding = 7) uniform usampler2DArray surfaces;

struct Surface {
    float cover; // 0: nothing
    float disparity;
    vec3 normal; // not of length one
    vec3 diffuse, specular, emissive;
    float shininess;
};

float disparityAt(int reference, int column, int row) {
    return texelFetch(disparities, ivec3(clamp(column, 0, lattice.x - 1), row, reference), 0).x;
}
bool isEdge(float a, float b) { return abs(a - b) > lineup.z; }
float positionOfReference(int reference) { return lineup.x + float(reference) * lineup.y; }

// Not of length one.
vec3 normalOf(uint bits) {
    vec2 square = 2.0 * unpackUnorm2x16(bits) - 1.0;
    vec3 normal = vec3(square, 1.0 - abs(square.x) - abs(square.y));
    float under = max(-normal.z, 0.0);
    normal.xy -= under * mix(vec2(-1.0), vec2(1.0), greaterThanEqual(square, vec2(0.0)));
    return normal;
}
vec3 diffuseIn(uvec4 texel) {
    return vec3(unpackHalf2x16(texel.z), unpackHalf2x16(texel.w).x);
}

// Between two texels of a row, `share` of the way to the second; the nearer one's material.
Surface surfaceBetween(ivec3 first, float share, bool isOne) {
    Surface surface;
    float weight = isOne ? round(share) : share;
    uvec4 a = texelFetch(surfaces, first, 0);
    uvec4 b = texelFetch(surfaces, ivec3(min(first.x + 1, lattice.x - 1), first.yz), 0);
    uint number = share < 0.5 ? a.x : b.x;
    int part = max(int(number) - 1, 0);
    surface.cover = number == 0u ? 0.0 : 1.0;
    surface.diffuse = mix(diffuseIn(a), diffuseIn(b), weight);
#ifdef PER_PIXEL
    surface.normal = mix(normalOf(a.y), normalOf(b.y), weight);
    surface.specular = specularOf(part);
    surface.shininess = diffuseOf(part).w;
#endif
    surface.emissive = emissiveOf(part);
    return surface;
}

// What a reference shows at a place, texels, centres at 0.5.
Surface surfaceAt(int reference, float x, int row) {
    float low = clamp(floor(x - 0.5), 0.0, float(lattice.x - 1));
    float share = clamp(x - 0.5 - low, 0.0, 1.0);
    ivec3 first = ivec3(int(low), row, reference);
    float a = disparityAt(reference, first.x, row), b = disparityAt(reference, first.x + 1, row);
    bool isOne = isEdge(a, b);
    Surface surface = surfaceBetween(first, share, isOne);
    surface.disparity = mix(a, b, isOne ? round(share) : share);
    return surface;
}
