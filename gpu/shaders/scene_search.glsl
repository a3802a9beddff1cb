// The surface that a ray (x, b) meets first, in the reference viewpoints' own depth (the
// super-multi-view paper, Eq. 3 and 4): what a reference at b_r shows at x_r with disparity d lies on
// the ray where x_r = x + (b - b_r) d, in texels. Walking x_r from the nearest disparity's to the
// farthest's is walking away from the eye; `above` is how far the ray is still in front. Between
// texels of one surface depth is linear; at an edge each keeps its half of the way; a ray that goes
// behind an edge is lost to this reference. Needs scene_surfaces.glsl.

struct Found {
    int reference;
    float x;    // in it, texels, centres at 0.5
    bool isGap; // x: of the edge
    int behind, edge; // columns beside a gap: what is seen past the edge, what hides
};

Found searchReference(int reference, int row, float x, float reach) {
    bool leftwards = reach >= 0.0;
    int step = leftwards ? -1 : 1;
    float way = -float(step), spread = abs(reach);
    // Peaks hold for views between two references.
    int block = clamp(int(x), 0, lattice.x - 1) / kPeakBlock;
    bool isBeside = spread * max(span.x, -span.y) <= float(lattice.y);
    float top = isBeside ? texelFetch(peaks, ivec3(block, row, reference), 0).x : span.x;
    float start = x + reach * top - 0.5;
    // A texel more than needed: rounding must not begin the walk behind the nearest surface.
    int at = leftwards ? int(ceil(start)) + 1 : int(floor(start)) - 1;
    int steps = int(ceil(spread * (top - span.y))) + 4;
    float near = disparityAt(reference, at, row), next = near;
    float above = way * (float(at) + 0.5 - x) - spread * near, below = above;
    bool edge = false;
    for (int left = steps; left > 0; --left) {
        at += step;
        next = disparityAt(reference, at, row);
        below = way * (float(at) + 0.5 - x) - spread * next;
        edge = isEdge(near, next);
        if (below <= 0.0 || (edge && above <= 0.5)) break;
        near = next;
        above = below;
    }
    float share = edge ? (above <= 0.5 ? above : 1.0 + below) : above / max(above - below, 1e-9);
    bool isLost = edge && above > 0.5 && below <= -0.5;
    bool isOutside = at < 1 || at >= lattice.x - 1;
    float found = float(at - step) + 0.5 + float(step) * clamp(share, 0.0, 1.0);
    return Found(reference, found, isLost || isOutside, at - step, at);
}

// In the nearest reference that sees it, else as the nearest of all has it. `x`: texels of a tile.
Found searchReferences(float x, float b, int row) {
    float place = lineup.w * (b - lineup.x);
    int nearest = clamp(int(floor(place + 0.5)), 0, lattice.w - 1);
    int side = place >= float(nearest) ? 1 : -1;
    Found best = Found(nearest, x, true, 0, 0);
    for (int turn = 0; turn < 2 * lattice.w && best.isGap; ++turn) {
        int reference = nearest + ((turn & 1) != 0 ? side : -side) * ((turn + 1) / 2);
        if (reference < 0 || reference >= lattice.w) continue;
        float reach = (b - positionOfReference(reference)) * float(lattice.x - 2 * lattice.y);
        Found found = searchReference(reference, row, x + float(lattice.y), reach);
        if (!found.isGap || turn == 0) best = found;
    }
    return best;
}
