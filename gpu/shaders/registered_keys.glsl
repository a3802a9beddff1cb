// What the passes of the registration keep for each pixel of the colour picture: one number, of
// which the greatest wins. Measured: the nearest, by the bits of 1/z, which grow with it, and the
// top bit. Extruded: behind all that, and of several the farthest. 0: nothing.
const uint kMeasured = 0x80000000u;

uint measuredKey(float inverseZ) { return kMeasured | floatBitsToUint(inverseZ); }
uint extrudedKey(float inverseZ) { return ~measuredKey(inverseZ); }

float depthOf(uint key) {
    if (key == 0u) return 0.0;
    return 1.0 / uintBitsToFloat((key >= kMeasured ? key : ~key) & ~kMeasured);
}
