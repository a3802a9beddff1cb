#version 450 core
// A mesh layer in the views. TILED: all of them in one instanced draw, cut to their tiles by clip
// distances; REPEATED: left to mesh_views.geom; else one view per draw, cut by the viewport.
#include "mesh_block.glsl"
#include "views_block.glsl"
#include "view_rig.glsl"

layout(binding = 0) uniform sampler2D points;
layout(binding = 1) uniform sampler2D sources;

layout(location = 0) out vec2 source;
#if defined(DISPARITY)
layout(location = 1) out float disparity;
#elif defined(REPEATED)
layout(location = 1) out vec3 point;
#endif
#ifdef TILED
out float gl_ClipDistance[4];
#endif

void main() {
    ivec2 node = ivec2(gl_VertexID % tiles.w, gl_VertexID / tiles.w);
    vec3 own = texelFetch(points, node, 0).xyz;
    source = texelFetch(sources, node, 0).xy;
#if defined(REPEATED)
    point = own;
#elif defined(TILED)
    vec3 place = placeInView(own, gl_InstanceID);
    vec4 inside = insideView(place);
    for (int edge = 0; edge < 4; ++edge) gl_ClipDistance[edge] = inside[edge];
    gl_Position = inTile(place, gl_InstanceID);
#else
    gl_Position = onPanel(placeInView(own, tiles.z));
#endif
#ifdef DISPARITY
    disparity = own.z;
#endif
}
