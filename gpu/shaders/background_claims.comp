#version 450 core
// Which texels a view may look behind, and what stands there: one invocation walks a row both ways.
// A step from a far surface to a near one opens, in some view, a gap as wide as their difference of
// disparity; near texels within it are claimed by the far surface. Texels without depth are claimed
// by what lies beside them.
#include "mesh_block.glsl"
#include "disparity.glsl"
#include "camera.glsl"
#include "cyclopean_grid.glsl"
#include "listed_blocks.glsl"

layout(local_size_x = 8) in;

layout(binding = 0) uniform sampler2D filled;
layout(rg32f, binding = 0) uniform image2D claims; // depth (m; 0: not claimed), texels to its edge
layout(rg32f, binding = 1) uniform image2D forward; // the same of the way there
layout(r8ui, binding = 2) uniform writeonly uimage2D changed;

const float kNone = 1e9;

// The nearer edge claims; of equals the farther surface, so that no order of walking shows.
vec2 better(vec2 a, vec2 b) {
    if (a.x == 0.0 || b.x == 0.0) return a.x == 0.0 ? b : a;
    return b.y < a.y || (b.y == a.y && b.x > a.x) ? b : a;
}

void walk(int row, int first, int step, int columns) {
    float texelsPerPanel = grid.x / (1.0 + 2.0 * grid.z);
    float last = 0.0, behind = 0.0;
    int edge = 0, lastColumn = first;
    for (int i = 0; i < columns; ++i) {
        int x = first + i * step;
        float z = texelFetch(filled, ivec2(x, row), 0).x;
        vec2 claim = vec2(0.0, kNone);
        if (z == 0.0) {
            if (last > 0.0) claim = vec2(last, float(abs(x - lastColumn)));
        } else {
            if (last > 0.0 && isBehind(last, z)) {
                behind = last;
                edge = x;
            }
            if (behind > 0.0 && !isBehind(behind, z)) behind = 0.0;
            if (behind > 0.0) {
                float gap = disparityAt(z, law, budget.xy) - disparityAt(behind, law, budget.xy);
                float distance = float(abs(x - edge));
                if (distance < gap * texelsPerPanel + 1.0) claim = vec2(behind, distance);
            }
            last = z;
            lastColumn = x;
        }
        ivec2 texel = ivec2(x, row);
        if (step > 0) {
            imageStore(forward, texel, vec4(claim, 0.0, 0.0));
            continue;
        }
        claim = better(imageLoad(forward, texel).xy, claim);
        if (imageLoad(claims, texel).xy == claim) continue;
        imageStore(claims, texel, vec4(claim, 0.0, 0.0));
        imageStore(changed, texel / 8, uvec4(1u));
    }
}

void main() {
    int row = listedBlock().y * 8 + int(gl_LocalInvocationID.x);
    ivec2 size = imageSize(claims);
    if (row >= size.y) return;
    walk(row, 0, 1, size.x);
    walk(row, size.x - 1, -1, size.x);
}
