#version 450 core
// A scene's triangles in the views. TILED: all of them in one instanced draw, cut to their tiles by
// clip distances; REPEATED: left to scene_view.geom; else one view per draw, cut by the viewport.
#include "scene_block.glsl"
#include "scene_parts.glsl"
#include "scene_eyes.glsl"
#include "scene_light.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 ownNormal;
layout(location = 2) in vec2 ownUv;
layout(location = 3) in uint part;

#ifdef REPEATED
layout(location = 0) out vec2 cornerUv;
layout(location = 1) flat out int cornerPart;
layout(location = 2) out vec3 cornerPlace;
layout(location = 3) out vec3 cornerNormal;
#else
#include "scene_corner.glsl"
#endif
#ifdef TILED
out float gl_ClipDistance[4];
#endif

void main() {
    vec3 corner = (toDisplay(int(part)) * vec4(position, 1.0)).xyz;
    vec3 turned = normalize(normalsToDisplay(int(part)) * ownNormal);
#if defined(REPEATED)
    cornerUv = ownUv;
    cornerPart = int(part);
    cornerPlace = corner;
    cornerNormal = turned;
#elif defined(TILED)
    handOver(corner, turned, ownUv, int(part), gl_InstanceID);
    vec4 seen = seenFrom(eyeOf(gl_InstanceID), corner);
    vec4 inside = insideView(seen);
    for (int edge = 0; edge < 4; ++edge) gl_ClipDistance[edge] = inside[edge];
    gl_Position = inTile(seen, gl_InstanceID);
#else
    handOver(corner, turned, ownUv, int(part), viewTiles.z);
    gl_Position = seenFrom(eyeOf(viewTiles.z), corner);
#endif
}
