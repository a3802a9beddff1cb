#include "gpu/view_interleaver.hpp"

#include <algorithm>
#include <iterator>

namespace autostereo::gpu {

namespace {

std::vector<std::string> variant(const calib::ViewMap& map, const InterleaverParams& params) {
    std::vector<std::string> defines;
    if (map.tables.lut) defines.emplace_back("LUT");
    if (map.tables.pattern.rows > 0) defines.emplace_back("PATTERN");
    const auto& cells = map.tables.affine.channels;
    if (std::ranges::any_of(cells, [&](const auto& cell) { return cell != cells.front(); }))
        defines.emplace_back("CELLS");
    if (!map.tables.grid.nodes.empty()) defines.emplace_back("GRID");
    if (!map.remap.empty()) defines.emplace_back("REMAP");
    if (map.reversed) defines.emplace_back("REVERSED");
    if (map.upsideDown) defines.emplace_back("UPSIDE_DOWN");
    if (params.fringe > 0) defines.emplace_back("FRINGE");
    if (params.filter == TileFilter::Nearest) defines.emplace_back("NEAREST");
    if (params.views == ViewFilter::Blend) defines.emplace_back("BLEND");
    std::ranges::move(definesOf(params.search), std::back_inserter(defines));
    return defines;
}

} // namespace

ViewInterleaver::ViewInterleaver(const calib::ViewMap& map, const InterleaverParams& params)
    : pass_("view_interleaver.frag", variant(map, params), map.tables.width, map.tables.height,
            params.search && (params.search->rootsOnly || params.search->tilesOnly)
                ? Cover::StaleTiles
                : Cover::Panel),
      grid_(map.tables.grid) {
    const calib::PhaseTables& tables = map.tables;
    pass_.block().fan.x = map.views;
    phase_.set(0, tables.affine);
    pass_.block().panel.z = std::max(1, tables.pattern.rows);
    pass_.block().edge.x = 1.0F / static_cast<float>(std::max(1, params.fringe));
    if (params.search) pass_.setSearch(*params.search);
    if (tables.lut)
        phaseTable_ = tableTexture(3, tables.width, tables.height, tables.lut->data());
    else if (tables.pattern.rows > 0)
        phaseTable_ =
            tableTexture(3, tables.width, tables.pattern.rows, tables.pattern.phases.data());
    if (!map.remap.empty())
        remap_ = tableTexture(1, static_cast<int>(map.remap.size()), 1, map.remap.data());
}

void ViewInterleaver::render(const DrawnViews& views, GLuint framebuffer) {
    uniforms_.bind(4, phase_);
    glBindTextureUnit(1, phaseTable_.name());
    grid_.bind();
    glBindTextureUnit(6, remap_.name());
    pass_.draw(views.atlas, framebuffer);
}

} // namespace autostereo::gpu
