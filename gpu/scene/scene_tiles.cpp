#include "gpu/scene/scene_tiles.hpp"

#include "gpu/gl/dispatch.hpp"

#include <string>
#include <vector>

namespace autostereo::gpu {

namespace {

std::vector<std::string> variant(bool upsideDown) {
    if (upsideDown) return {"UPSIDE_DOWN"};
    return {};
}

} // namespace

SceneTiles::SceneTiles(int panelWidth, int panelHeight, const SearchParams& search, bool upsideDown)
    : program_({"scene_tiles.comp"}, variant(upsideDown)), tiles_(panelWidth, panelHeight) {
    block_.panel = {panelWidth, panelHeight, 1, 1};
    block_.fine = {1.0F / static_cast<float>(panelWidth), 1.0F / static_cast<float>(panelHeight),
                   static_cast<float>(search.channelStep), 0.0F};
}

void SceneTiles::list() {
    tiles_.clear();
    tiles_.bind(2);
    uniforms_.bind(2, block_);
    gl::dispatch(program_, tiles_.across(), tiles_.down());
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    tiles_.bindToDraw();
}

} // namespace autostereo::gpu
