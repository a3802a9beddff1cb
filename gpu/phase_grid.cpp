#include "gpu/phase_grid.hpp"

#include "gpu/panel_pass.hpp"

namespace autostereo::gpu {

namespace {

gl::Texture placesTexture(const std::vector<calib::GridTables::Place>& places) {
    std::vector<std::uint32_t> pairs;
    for (const auto& place : places) {
        pairs.push_back(place.node);
        pairs.push_back(place.weight);
    }
    return tableTexture(2, static_cast<int>(places.size()), 1, pairs.data());
}

} // namespace

PhaseGrid::PhaseGrid(const calib::GridTables& tables) {
    if (tables.nodes.empty()) return;
    nodes_ = tableTexture(1, tables.columns, tables.rows, tables.nodes.data());
    columns_ = placesTexture(tables.columnPlaces);
    rows_ = placesTexture(tables.rowPlaces);
}

void PhaseGrid::bind() const {
    glBindTextureUnit(3, nodes_.name());
    glBindTextureUnit(4, columns_.name());
    glBindTextureUnit(5, rows_.name());
}

} // namespace autostereo::gpu
