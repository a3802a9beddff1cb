#version 450 core
// Depth for texels without sure depth, from the nearest of their row and column. Where those lie on
// one surface it goes on between them; else the texel belongs to the nearest surface close by that
// has about its colour, so that what is mixed at an edge moves with what stands in front, and
// farther off to the surface behind. What was measured of a thing too thin to be sure of anywhere
// stays.
#include "mesh_block.glsl"
#include "camera.glsl"
#include "cyclopean_grid.glsl"
#include "listed_blocks.glsl"

layout(local_size_x = 8, local_size_y = 8) in;

layout(binding = 0) uniform sampler2D sure; // m; 0: none
layout(binding = 2) uniform sampler2D measured;
layout(binding = 1) uniform sampler2D colorImage;
layout(r32f, binding = 0) uniform image2D filled;
layout(r8ui, binding = 1) uniform writeonly uimage2D changed;
layout(r8ui, binding = 2) uniform writeonly uimage2D changedScene;

layout(std140, binding = 3) uniform FillBlock {
    ivec4 reach; // texels: farthest measurement used, how near an edge colours decide, -, unsure band
};

// Rows and columns first.
const ivec2 kDirections[8] = ivec2[8](ivec2(-1, 0), ivec2(1, 0), ivec2(0, -1), ivec2(0, 1),
                                      ivec2(-1, -1), ivec2(1, 1), ivec2(1, -1), ivec2(-1, 1));
const int kSamples = 3;      // a direction
const float kAnyLike = 1e4;  // m: like colours, then the nearest; else the most like one

// Sum of squares, of 1 a channel. Coarse depth ends anywhere in an edge's mixed colours (differences
// of 0.16 a channel); depth as fine as the colours ends where they do (0.04).
float likeColor() { return reach.w > 0 ? 0.08 : 0.005; }

vec3 colorAt(ivec2 texel) {
    return texture(colorImage, sourceFromPanel(panelFromTexel(vec2(texel)))).rgb;
}

bool isOnGrid(ivec2 texel, ivec2 size) {
    return all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, size));
}

bool areOne(float a, float b) { return !isBehind(a, b) && !isBehind(b, a); }

struct Neighbour {
    float z; // 0: none within reach
    int steps;
};

Neighbour look(ivec2 texel, ivec2 direction, ivec2 size) {
    for (int steps = 1; steps <= reach.x; ++steps) {
        ivec2 place = texel + direction * steps;
        if (!isOnGrid(place, size)) break;
        float z = texelFetch(sure, place, 0).x;
        if (z > 0.0) return Neighbour(z, steps);
    }
    return Neighbour(0.0, 0);
}

float surfaceByColor(ivec2 texel, ivec2 size, vec3 own, float otherwise) {
    float chosen = otherwise, least = 1e30;
    for (int i = 0; i < 8; ++i) {
        int samples = 0;
        for (int steps = 1; steps <= reach.y && samples < kSamples; ++steps) {
            ivec2 place = texel + kDirections[i] * steps;
            if (!isOnGrid(place, size)) break;
            float z = texelFetch(measured, place, 0).x;
            if (z == 0.0) continue;
            ++samples;
            vec3 off = own - colorAt(place);
            float score = dot(off, off) < likeColor() ? z : kAnyLike * (1.0 + dot(off, off));
            if (score < least) {
                least = score;
                chosen = z;
            }
        }
    }
    return chosen;
}

float fill(ivec2 texel, ivec2 size, vec3 own) {
    Neighbour found[4];
    float nearest = 1e30, farthest = 0.0;
    float unsure = texelFetch(measured, texel, 0).x;
    bool alone = unsure > 0.0;
    for (int i = 0; i < 4; ++i) {
        found[i] = look(texel, kDirections[i], size);
        if (found[i].z == 0.0) continue;
        alone = alone && (found[i].steps > reach.y || !areOne(found[i].z, unsure));
        nearest = min(nearest, found[i].z);
        farthest = max(farthest, found[i].z);
    }
    if (alone || farthest == 0.0) return unsure;
    bool split = isBehind(farthest, nearest);
    float chosen = split ? surfaceByColor(texel, size, own, farthest) : farthest;
    float sum = 0.0, weights = 0.0;
    for (int i = 0; i < 4; ++i) {
        if (found[i].z == 0.0 || !areOne(found[i].z, chosen)) continue;
        float weight = 1.0 / float(found[i].steps);
        sum += weight / found[i].z;
        weights += weight;
    }
    return weights > 0.0 ? weights / sum : chosen;
}

void main() {
    ivec2 texel = listedTexel();
    ivec2 size = imageSize(filled);
    if (any(greaterThanEqual(texel, size))) return;
    float z = texelFetch(sure, texel, 0).x;
    vec2 source = sourceFromPanel(panelFromTexel(vec2(texel)));
    if (!isInPicture(source)) {
        z = 0.0; // nothing to show there
    } else if (z == 0.0) {
        z = fill(texel, size, texture(colorImage, source).rgb);
    }
    z = orBackdrop(z);
    if (imageLoad(filled, texel).x == z) return;
    imageStore(filled, texel, vec4(z));
    imageStore(changed, listedBlock(), uvec4(1u));
    imageStore(changedScene, listedBlock(), uvec4(1u));
}
