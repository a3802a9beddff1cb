#include "gpu/depth_frame_packer.hpp"

#include "calib/depth_frame_header.hpp"

namespace autostereo::gpu {

namespace {

gl::Texture headerTexture(const calib::DepthFrame& frame) {
    if (!frame.header) return {};
    std::vector<std::uint32_t> levels;
    for (const std::uint8_t level : calib::depthFrameHeaderRow(frame))
        levels.push_back(level);
    return tableTexture(1, static_cast<int>(levels.size()), 1, levels.data());
}

} // namespace

DepthFramePacker::DepthFramePacker(const calib::DepthFrame& frame, int width, int height)
    : pass_("depth_frame.frag",
            frame.header ? std::vector<std::string>{"HEADER"} : std::vector<std::string>{}, width,
            height),
      header_(headerTexture(frame)) {
    pass_.block().edge.z = static_cast<float>(frame.screenLevel);
    pass_.block().edge.w = static_cast<float>(frame.gain);
}

void DepthFramePacker::render(const DrawnViews& views, GLuint framebuffer) {
    glBindTextureUnit(1, views.disparity->name());
    glBindTextureUnit(2, header_.name());
    pass_.draw(views.atlas, framebuffer);
}

} // namespace autostereo::gpu
