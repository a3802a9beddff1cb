#include "gpu/view_interleaver.hpp"

namespace autostereo::gpu {

namespace {

std::vector<std::string> variant(const calib::ViewMap& map, const InterleaverParams& params) {
    std::vector<std::string> defines;
    if (map.tables.lut) defines.emplace_back("LUT");
    if (map.tables.rowPeriod > 1) defines.emplace_back("CELLS");
    if (!map.tables.grid.nodes.empty()) defines.emplace_back("GRID");
    if (!map.remap.empty()) defines.emplace_back("REMAP");
    if (params.filter == TileFilter::Nearest) defines.emplace_back("NEAREST");
    if (params.views == ViewFilter::Blend) defines.emplace_back("BLEND");
    return defines;
}

gl::Texture placesTexture(const std::vector<calib::GridTables::Place>& places) {
    std::vector<std::uint32_t> pairs;
    for (const auto& place : places) {
        pairs.push_back(place.node);
        pairs.push_back(place.weight);
    }
    return tableTexture(2, static_cast<int>(places.size()), 1, pairs.data());
}

} // namespace

ViewInterleaver::ViewInterleaver(const calib::ViewMap& map, const InterleaverParams& params)
    : pass_("view_interleaver.frag", variant(map, params), map.tables.width, map.tables.height) {
    const calib::PhaseTables& tables = map.tables;
    pass_.block().fan = {map.views, map.reversed ? 1U : 0U, 0U, 0U};
    pass_.block().panel.z = tables.rowPeriod;
    pass_.block().tiles.w = map.upsideDown ? 1 : 0;
    pass_.block().edge.x = params.fringe > 0 ? 1.0F / static_cast<float>(params.fringe) : 0.0F;
    if (tables.lut) {
        columnPhases_ = tableTexture(3, tables.width, tables.height, tables.lut->data());
    } else {
        columnPhases_ = tableTexture(3, tables.width, tables.rowPeriod, tables.columns.data());
        rowPhases_ = tableTexture(1, tables.height, 1, tables.rows.data());
    }
    if (!tables.grid.nodes.empty()) {
        gridNodes_ =
            tableTexture(1, tables.grid.columns, tables.grid.rows, tables.grid.nodes.data());
        gridColumns_ = placesTexture(tables.grid.columnPlaces);
        gridRows_ = placesTexture(tables.grid.rowPlaces);
    }
    if (!map.remap.empty())
        remap_ = tableTexture(1, static_cast<int>(map.remap.size()), 1, map.remap.data());
}

void ViewInterleaver::render(const DrawnViews& views, GLuint framebuffer) {
    GLuint unit = 1;
    for (const gl::Texture* table :
         {&columnPhases_, &rowPhases_, &gridNodes_, &gridColumns_, &gridRows_, &remap_})
        glBindTextureUnit(unit++, table->name());
    pass_.draw(*views.atlas, framebuffer);
}

} // namespace autostereo::gpu
