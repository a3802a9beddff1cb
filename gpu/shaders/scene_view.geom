#version 450 core
// Each triangle, VIEWS times: into its tile of the atlas, cut there by clip distances (de Sorbier
// 2010), or, LAYERED, into its view's layer of the target (de Sorbier 2008).
#include "scene_block.glsl"
#include "scene_parts.glsl"
#include "scene_eyes.glsl"
#include "scene_light.glsl"

layout(triangles) in;
layout(triangle_strip, max_vertices = 3 * VIEWS) out;

layout(location = 0) in vec2 cornerUv[];
layout(location = 1) flat in int cornerPart[];
layout(location = 2) in vec3 cornerPlace[];
layout(location = 3) in vec3 cornerNormal[];
#include "scene_corner.glsl"
#ifndef LAYERED
out float gl_ClipDistance[4];
#endif

void repeat(int view) {
    for (int i = 0; i < 3; ++i) {
        handOver(cornerPlace[i], cornerNormal[i], cornerUv[i], cornerPart[i], view);
        vec4 seen = seenFrom(eyeOf(view), cornerPlace[i]);
#ifdef LAYERED
        gl_Layer = view;
        gl_Position = seen;
#else
        vec4 inside = insideView(seen);
        for (int edge = 0; edge < 4; ++edge) gl_ClipDistance[edge] = inside[edge];
        gl_Position = inTile(seen, view);
#endif
        EmitVertex();
    }
    EndPrimitive();
}

void main() {
    int last = min(viewTiles.z + VIEWS, viewTiles.w);
    for (int view = viewTiles.z; view < last; ++view) repeat(view);
}
