#pragma once

#include "devices/frame_pool.hpp"
#include "gpu/frame_uploader.hpp"
#include "tests/device/v4l2/reading.hpp"
#include "tests/device/v4l2/vivid.hpp"
#include "tests/support/gl_fixture.hpp"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace autostereo::test {

/// Pictures of the kernel's test camera, through the uploader.
class VividGlTest : public GlTest {
  protected:
    using Rgba = std::vector<std::uint8_t>;

    void SetUp() override {
        if (!Vivid::there()) GTEST_SKIP() << "no vivid here: run in the guest";
        GlTest::SetUp();
        if (IsSkipped() || HasFatalFailure()) return;
        Vivid::reset();
        uploader.emplace();
    }
    void TearDown() override {
        uploader.reset();
        GlTest::TearDown();
    }
    void upload(gpu::FrameUploader& to, devices::RgbdFrame& pair) {
        if (pair.depth.empty()) pair.depth = *pool.acquire({devices::PixelFormat::Depth16, 4, 4});
        to.upload(pair);
    }
    /// Top row first.
    static Rgba seen(const gpu::FrameUploader& from) {
        const gpu::gl::Texture& color = from.color();
        Rgba rgba(4 * static_cast<std::size_t>(color.width()) *
                  static_cast<std::size_t>(color.height()));
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTextureImage(color.name(), 0, GL_RGBA, GL_UNSIGNED_BYTE,
                          static_cast<GLsizei>(rgba.size()), rgba.data());
        return rgba;
    }

    devices::FramePool pool{8};
    std::optional<gpu::FrameUploader> uploader; ///< needs the context
};

} // namespace autostereo::test
