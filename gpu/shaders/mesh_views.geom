#version 450 core
// Each triangle, VIEWS times: into its tile of the atlas, cut there by clip distances (de Sorbier
// 2010), or, LAYERED, into its view's layer of the target (de Sorbier 2008).
#include "mesh_block.glsl"
#include "views_block.glsl"
#include "view_rig.glsl"

layout(triangles) in;
layout(triangle_strip, max_vertices = 3 * VIEWS) out;

layout(location = 0) in vec2 sources[];
layout(location = 1) in vec3 points[];
layout(location = 0) out vec2 source;
#ifndef LAYERED
out float gl_ClipDistance[4];
#endif

void repeat(int view) {
    for (int i = 0; i < 3; ++i) {
        vec3 place = placeInView(points[i], view);
        source = sources[i];
#ifdef LAYERED
        gl_Layer = view;
        gl_Position = onPanel(place);
#else
        vec4 inside = insideView(place);
        for (int edge = 0; edge < 4; ++edge) gl_ClipDistance[edge] = inside[edge];
        gl_Position = inTile(place, view);
#endif
        EmitVertex();
    }
    EndPrimitive();
}

void main() {
    int last = min(tiles.z + VIEWS, textureSize(viewPositions, 0).x);
    for (int view = tiles.z; view < last; ++view) repeat(view);
}
