// Camera depth (m) -> disparity at |b| = 1, panel widths; twin of calib::DisparityLaw.
float disparityAt(float z, vec4 law, vec2 budget) {
    float height = law.y * (law.x - z);
    float gap = law.z - height;
    return gap > 0.0 ? clamp(law.w * height / gap, budget.x, budget.y) : budget.y;
}
