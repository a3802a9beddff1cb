// What a pixel of a view shows of the reference viewpoints, as 32 bits: which one, and where in its
// row in 2^-13 texels; or nothing; or a hole that no reference sees.
const uint kHole = 0xf0000000u, kNothing = 0xe0000000u;
const float kRootSteps = 8192.0;

uint rootOf(int reference, float x) {
    return uint(reference) << 28 | uint(clamp(x, 0.0, 32767.0) * kRootSteps + 0.5);
}
int referenceOf(uint root) { return int(root >> 28); }
float columnOf(uint root) { return float(root & 0x0fffffffu) / kRootSteps; }
