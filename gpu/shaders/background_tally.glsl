// How much of the picture stands farther off than what is remembered there.
layout(std430, binding = 0) buffer Tally {
    uvec2 before; // of the last frame: texels compared, and of these seen farther off
    uvec2 now;
    uint compared[]; // a block
};

// So much of the picture does not step back at once: the camera was moved.
bool isMoved(uvec2 tally) { return 10u * tally.y > 3u * tally.x; }
