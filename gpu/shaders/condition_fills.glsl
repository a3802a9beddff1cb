// Pixels of a block of 8 x 8 that were filled, and that stay holes.
layout(std430, binding = 0) buffer Fills { uint fills[]; };
