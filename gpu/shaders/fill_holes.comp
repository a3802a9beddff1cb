#version 450 core
// Depth for texels without sure depth, from the nearest of their row and column. Where those lie on
// one surface it goes on between them; else the texel belongs, close to an edge, to the surface whose
// colour it has, and farther off to the surface behind. What was measured of a thing too thin to be
// sure of anywhere stays.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "cyclopean_grid.glsl"

layout(local_size_x = 16, local_size_y = 16) in;

layout(binding = 0) uniform sampler2D sure; // m; 0: none
layout(binding = 2) uniform sampler2D measured;
layout(binding = 1) uniform sampler2D colorImage;
layout(r32f, binding = 0) uniform writeonly image2D filled;

layout(std140, binding = 3) uniform FillBlock {
    ivec4 reach; // texels: farthest measurement used, how near an edge colours decide
};

const ivec2 kDirections[4] = ivec2[4](ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1));
const int kInside = 2;             // texels: colour at the very edge is mixed
const float kColorWeight = 40.0;   // against steps: a difference of 0.16 weighs as much as one texel

vec3 colorAt(ivec2 texel) {
    return texture(colorImage, sourceFromPanel(panelFromTexel(vec2(texel)))).rgb;
}

bool isOnGrid(ivec2 texel, ivec2 size) {
    return all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, size));
}

float sureAt(ivec2 texel, ivec2 size) {
    return isOnGrid(texel, size) ? texelFetch(sure, texel, 0).x : 0.0;
}

bool areOne(float a, float b) { return !isBehind(a, b) && !isBehind(b, a); }

struct Neighbour {
    float z; // 0: none within reach
    int steps;
    float cost;
};

Neighbour look(ivec2 texel, ivec2 direction, vec3 own, ivec2 size) {
    for (int steps = 1; steps <= reach.x; ++steps) {
        ivec2 place = texel + direction * steps;
        if (!isOnGrid(place, size)) break;
        float z = texelFetch(sure, place, 0).x;
        if (z == 0.0) continue;
        ivec2 within = place + direction * kInside;
        float zWithin = sureAt(within, size);
        bool sameSurface = zWithin > 0.0 && areOne(zWithin, z);
        vec3 off = own - colorAt(sameSurface ? within : place);
        return Neighbour(z, steps, kColorWeight * dot(off, off) + float(steps));
    }
    return Neighbour(0.0, 0, 0.0);
}

float fill(ivec2 texel, ivec2 size, vec3 own) {
    Neighbour found[4];
    float nearest = 1e30, farthest = 0.0;
    float unsure = texelFetch(measured, texel, 0).x;
    bool alone = unsure > 0.0;
    for (int i = 0; i < 4; ++i) {
        found[i] = look(texel, kDirections[i], own, size);
        if (found[i].z == 0.0) continue;
        alone = alone && (found[i].steps > reach.y || !areOne(found[i].z, unsure));
        nearest = min(nearest, found[i].z);
        farthest = max(farthest, found[i].z);
    }
    if (alone || farthest == 0.0) return unsure;
    bool split = isBehind(farthest, nearest);
    float chosen = farthest, least = 1e30;
    for (int i = 0; i < 4; ++i) {
        if (!split || found[i].z == 0.0 || found[i].steps > reach.y) continue;
        if (found[i].cost < least) {
            least = found[i].cost;
            chosen = found[i].z;
        }
    }
    float sum = 0.0, weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        if (found[i].z == 0.0 || !areOne(found[i].z, chosen)) continue;
        float weight = 1.0 / float(found[i].steps);
        sum += weight / found[i].z;
        weights += weight;
    }
    return weights / sum;
}

void main() {
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    ivec2 size = imageSize(filled);
    if (any(greaterThanEqual(texel, size))) return;
    float z = texelFetch(sure, texel, 0).x;
    vec2 source = sourceFromPanel(panelFromTexel(vec2(texel)));
    if (!isInPicture(source)) {
        z = 0.0; // nothing to show there
    } else if (z == 0.0) {
        z = fill(texel, size, texture(colorImage, source).rgb);
    }
    imageStore(filled, texel, vec4(orBackdrop(z)));
}
