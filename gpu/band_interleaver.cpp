#include "gpu/band_interleaver.hpp"

namespace autostereo::gpu {

namespace {

std::vector<std::string> variant(const calib::BandMap& map, const InterleaverParams& params) {
    std::vector<std::string> defines;
    if (map.waveform) defines.emplace_back("WAVEFORM");
    if (params.filter == TileFilter::Nearest) defines.emplace_back("NEAREST");
    return defines;
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
    : pass_("band_interleaver.frag", variant(map, params), map.eyes.front().width,
            map.eyes.front().height),
      columnPhases_(GL_RGBA32UI, map.eyes.front().width, static_cast<int>(map.eyes.size())),
      rowPhases_(GL_R32UI, map.eyes.front().height, static_cast<int>(map.eyes.size())) {
    pass_.block().fan = {map.eyes.size(), 0U, map.start, map.width};
    pass_.block().panel.w = static_cast<int>(map.eyes.size());
    pass_.block().edge.x = params.fringe > 0 ? 1.0F / static_cast<float>(params.fringe) : 0.0F;
    if (map.waveform) {
        edges_ = edgesTexture(*map.waveform);
        pass_.block().edge.y = static_cast<float>(map.waveform->negativeLobe);
    }
    update(map);
}

void BandInterleaver::update(const calib::BandMap& map) {
    int row = 0;
    for (const calib::PhaseTables& eye : map.eyes) {
        glTextureSubImage2D(columnPhases_.name(), 0, 0, row, eye.width, 1, GL_RGB_INTEGER,
                            GL_UNSIGNED_INT, eye.columns.data());
        glTextureSubImage2D(rowPhases_.name(), 0, 0, row, eye.height, 1, GL_RED_INTEGER,
                            GL_UNSIGNED_INT, eye.rows.data());
        ++row;
    }
}

void BandInterleaver::render(const DrawnViews& views, GLuint framebuffer) {
    glBindTextureUnit(1, columnPhases_.name());
    glBindTextureUnit(2, rowPhases_.name());
    glBindTextureUnit(3, edges_.name());
    pass_.draw(*views.atlas, framebuffer);
}

} // namespace autostereo::gpu
