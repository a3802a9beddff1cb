// What a sub-pixel shows, as 21 bits: where on its row of the grid, in 2^-20 of its width, and on which
// layer. Three in 64 bits.
const uint kRootBits = 21u;
const uint kBlackRoot = 0x1fffffu;
const float kRootSteps = 1048574.0; // one less than would meet kBlackRoot

uint rootOf(float share, int layer) {
    return uint(clamp(share, 0.0, 1.0) * kRootSteps + 0.5) | uint(layer) << 20;
}
float shareOf(uint root) { return float(root & 0xfffffu) / kRootSteps; }
int layerOf(uint root) { return int(root >> 20); }

uvec2 packRoots(uvec3 roots) {
    return uvec2(roots.x | roots.y << kRootBits, roots.y >> 11 | roots.z << 10);
}
uvec3 unpackRoots(uvec2 bits) {
    return uvec3(bits.x, bits.x >> kRootBits | bits.y << 11, bits.y >> 10) & kBlackRoot;
}
