#version 450 core
// All views' tiles from a few reference views (the super-multi-view paper, Eq. 3 to 5, as it is for
// pictures without lights): each pixel finds the first surface behind it in the nearest reference,
// falls through to the other ones where that has a gap, and else continues the surface behind it.
#include "mesh_block.glsl"

layout(std140, binding = 3) uniform HybridBlock {
    ivec4 tiles;     // columns of the atlas, tile width, height; references
    vec4 references; // b of the first one, step to the next; step in disparity that is a gap
};
layout(binding = 0) uniform sampler2D colors;      // reference after reference, left to right
layout(binding = 1) uniform sampler2D disparities;
layout(binding = 3) uniform sampler2D viewPositions; // b of each view, left to right

layout(location = 0) out vec4 color;

struct Found {
    float x; // tile pixels, centres at 0.5
    bool isGap;
    float disparity; // of the surface that is continued across a gap
};

float disparityAt(int reference, int x, int y) {
    return texelFetch(disparities, ivec2(reference * tiles.y + clamp(x, 0, tiles.y - 1), y), 0).x;
}

// First pixel of a reference that lies on the ray x + reach d, from the near end on.
Found search(int reference, float x, int y, float reach) {
    bool leftwards = reach >= 0.0;
    int step = leftwards ? -1 : 1;
    float way = -float(step), spread = abs(reach);
    float start = x + reach * budget.y - 0.5;
    int at = leftwards ? int(ceil(start)) : int(floor(start));
    int steps = int(ceil(spread * (budget.y - budget.x))) + 2;
    float near = disparityAt(reference, at, y);
    float above = way * (float(at) + 0.5 - x) - spread * near;
    Found found = Found(x + reach * near, above <= 0.0 && (at < 0 || at >= tiles.y), near);
    if (above <= 0.0) return found;
    for (int left = steps; left > 0; --left) {
        at += step;
        float next = disparityAt(reference, at, y);
        float below = way * (float(at) + 0.5 - x) - spread * next;
        if (below <= 0.0) {
            bool isJump = abs(next - near) > references.z;
            float share = above / (above - below);
            found.disparity = min(near, next);
            found.x = float(at) + 0.5 - float(step) * (1.0 - share);
            if (isJump) found.x = next < near ? float(at) + 0.5 : float(at - step) + 0.5;
            found.isGap = isJump || at < 0 || at >= tiles.y;
            return found;
        }
        near = next;
        above = below;
    }
    return Found(x + reach * near, true, near);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 tile = pixel / tiles.yz, inside = pixel - tile * tiles.yz;
    int view = tile.y * tiles.x + tile.x;
    if (tile.x >= tiles.x || view >= textureSize(viewPositions, 0).x) discard;
    float b = texelFetch(viewPositions, ivec2(view, 0), 0).x;
    float x = float(inside.x) + 0.5;
    int nearest = clamp(int(floor((b - references.x) / references.y + 0.5)), 0, tiles.w - 1);
    Found best = Found(x, true, 1e9);
    int chosen = nearest;
    for (int turn = 0; turn < tiles.w && best.isGap; ++turn) {
        int reference = (nearest + turn) % tiles.w;
        float from = references.x + float(reference) * references.y;
        Found found = search(reference, x, inside.y, (b - from) * float(tiles.y));
        if (!found.isGap || found.disparity < best.disparity) {
            best = found;
            chosen = reference;
        }
    }
    float place = clamp(best.x, 0.5, float(tiles.y) - 0.5) + float(chosen * tiles.y);
    vec2 size = vec2(textureSize(colors, 0));
    color = textureLod(colors, vec2(place, float(inside.y) + 0.5) / size, 0.0);
}
