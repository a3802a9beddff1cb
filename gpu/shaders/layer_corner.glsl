// Corners of a layer's quads, one quad a texel. Needs mesh_block.glsl, disparity.glsl,
// cyclopean_grid.glsl.
float depthAt(sampler2D layer, ivec2 texel) {
    ivec2 size = textureSize(layer, 0);
    bool onGrid = all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, size));
    return onGrid ? texelFetch(layer, texel, 0).x : 0.0;
}

bool areOne(float a, float b) {
    return a > 0.0 && b > 0.0 && !isBehind(a, b) && !isBehind(b, a);
}

struct Corner {
    float disparity, z;      // means over the texels around it that are one surface with `own`
    float nearest, farthest; // of all around it; 0: nothing there
};

// The corner whose lower right texel is `at`. Always summed in the same order, so that texels of one
// surface get the same number, bit for bit, and no ray slips through between them.
Corner cornerOf(sampler2D layer, ivec2 at, float own, bool isWhole) {
    Corner corner = Corner(0.0, 0.0, own, own);
    float inverse = 0.0, parts = 0.0;
    for (int i = 0; i < 4; ++i) {
        float z = depthAt(layer, at - ivec2(i & 1, i >> 1));
        corner.nearest = min(corner.nearest, z);
        corner.farthest = max(corner.farthest, z);
        if (!(isWhole ? z > 0.0 : areOne(own, z))) continue;
        corner.disparity += disparityAt(z, law, budget.xy);
        inverse += 1.0 / z;
        parts += 1.0;
    }
    corner.disparity /= parts;
    corner.z = parts / inverse;
    return corner;
}
