#include "gpu/band_interleaver.hpp"

#include "gpu/gl/error.hpp"

#include <algorithm>
#include <iterator>
#include <string>

namespace autostereo::gpu {

namespace {

std::vector<std::string> variant(const calib::BandMap& map, const InterleaverParams& params) {
    std::vector<std::string> defines;
    if (!map.eyes.front().grid.nodes.empty()) defines.emplace_back("GRID");
    if (map.waveform) defines.emplace_back("WAVEFORM");
    if (params.fringe > 0) defines.emplace_back("FRINGE");
    if (params.filter == TileFilter::Nearest) defines.emplace_back("NEAREST");
    std::ranges::move(definesOf(params.search), std::back_inserter(defines));
    return defines;
}

const calib::BandMap& allowed(const calib::BandMap& map, std::size_t most) {
    if (map.eyes.size() > most)
        throw GlError("gl: " + std::to_string(map.eyes.size()) +
                      " eyes behind one barrier (allowed up to " + std::to_string(most) + ")");
    return map;
}

gl::Texture edgesTexture(const calib::Waveform& waveform) {
    std::vector<float> texels;
    for (const auto& channel : waveform.edges)
        for (const double edge : channel)
            texels.push_back(static_cast<float>(edge));
    gl::Texture texture(GL_RGBA32F, 3, 1);
    glTextureSubImage2D(texture.name(), 0, 0, 0, 3, 1, GL_RGBA, GL_FLOAT, texels.data());
    return texture;
}

} // namespace

BandInterleaver::BandInterleaver(const calib::BandMap& map, const InterleaverParams& params)
    : pass_("band_interleaver.frag", variant(allowed(map, kMostEyes), params),
            map.eyes.front().width, map.eyes.front().height),
      grid_(map.eyes.front().grid) {
    pass_.block().fan = {map.eyes.size(), 0U, map.start, map.width};
    pass_.block().panel.w = static_cast<int>(map.eyes.size());
    pass_.block().edge.x = 1.0F / static_cast<float>(std::max(1, params.fringe));
    if (params.search) pass_.setSearch(*params.search);
    if (map.waveform) {
        edges_ = edgesTexture(*map.waveform);
        pass_.block().edge.y = static_cast<float>(map.waveform->negativeLobe);
    }
    update(map);
}

void BandInterleaver::update(const calib::BandMap& map) {
    for (std::size_t eye = 0; eye < map.eyes.size(); ++eye)
        phases_.set(eye, map.eyes[eye].affine);
}

void BandInterleaver::render(const DrawnViews& views, GLuint framebuffer) {
    uniforms_.bind(4, phases_);
    grid_.bind();
    glBindTextureUnit(1, edges_.name());
    pass_.draw(views.atlas, framebuffer);
}

} // namespace autostereo::gpu
