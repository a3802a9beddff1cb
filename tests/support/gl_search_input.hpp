#pragma once

#include "gpu/pipeline.hpp"
#include "gpu/views/layer_search.hpp"
#include "tests/oracle/first_hit_oracle.hpp"
#include "tests/support/gl_scene.hpp"

#include <utility>
#include <vector>

namespace autostereo::test {

/// The layers as the GPU searches them, for searching them in double precision.
inline oracle::SearchInput searchInput(const calib::SensorRig& rig,
                                       const gpu::SceneGeometry& geometry,
                                       const gpu::CyclopeanScene& scene, oracle::Picture color) {
    gpu::LayerSearch search;
    search.build(scene);
    const int columns = search.quads().width(), rows = search.quads().height() / 2;
    std::vector<glm::vec4> texels(static_cast<std::size_t>(columns) *
                                  static_cast<std::size_t>(2 * rows));
    glGetTextureImage(search.quads().name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(texels.size() * sizeof(glm::vec4)), texels.data());
    const auto layer = [&](int first) {
        return oracle::Grid<oracle::Quad>::of(columns, rows, [&](int x, int y) {
            const glm::vec4& quad =
                texels[static_cast<std::size_t>(first + y) * static_cast<std::size_t>(columns) +
                       static_cast<std::size_t>(x)];
            return oracle::Quad{quad.x, quad.y, quad.z, quad.w};
        });
    };
    return {rig,         geometry,         layer(0),
            layer(rows), std::move(color), readPicture(scene.backgroundColor)};
}

inline oracle::SearchInput searchInput(const calib::SensorRig& rig, const gpu::Pipeline& pipeline,
                                       oracle::Picture color) {
    return searchInput(rig, pipeline.geometry(), pipeline.scene(), std::move(color));
}

} // namespace autostereo::test
