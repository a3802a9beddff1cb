// calib::AffinePhase in halves of 32 and 16 bits: x, y < 2^14 keep the low sum below 2^32.
#ifndef EYES
#define EYES 1
#endif
layout(std140, binding = 4) uniform PhaseBlock {
    uvec4 phaseSteps[EYES];          // per column, per row: high 32 bits; low 16 bits
    uvec4 channels[EYES * 8]; // R, G, B of each cell: offset included
};

// Of a pixel from the top left.
uvec3 affinePhases(int eye, uvec2 place) {
#ifdef CELLS
    int cell = 8 * eye + int(2u * (place.y & 3u) + (place.x & 1u));
#else
    int cell = 8 * eye;
#endif
    uint low = place.x * phaseSteps[eye].z + place.y * phaseSteps[eye].w + 0x8000u;
    return place.x * phaseSteps[eye].x + place.y * phaseSteps[eye].y + (low >> 16) + channels[cell].xyz;
}
