#pragma once

#include "tests/device/v4l2/vivid_gl_fixture.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace autostereo::test {

/// Pictures of a camera, through the uploader: what the GPU makes of them where the driver left
/// them, beside what it makes of their bytes.
class ZeroCopyTest : public VividGlTest {
  protected:
    static constexpr const char* kVivid = "v4l2:/dev/video0?size=640x480&format=";

    /// The guest's card is where no GL driver sees it; only this program is to.
    static bool showCard() {
        std::error_code error;
        if (!std::filesystem::exists("/dev/dri", error))
            std::filesystem::create_symlink("vgem", "/dev/dri", error);
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
        return std::filesystem::exists("/dev/dri/card0", error);
    }
    void SetUp() override {
        ASSERT_TRUE(!Vivid::there() || showCard());
        VividGlTest::SetUp();
    }
    /// The same pixels in memory of ours.
    devices::Frame copyOf(const devices::Frame& frame) {
        auto copy = pool.acquire(frame.metadata());
        std::ranges::copy(frame.pixels(), copy->pixels().begin());
        return std::move(*copy);
    }
    static std::size_t openFiles() {
        using Entries = std::filesystem::directory_iterator;
        return static_cast<std::size_t>(std::distance(Entries("/proc/self/fd"), Entries()));
    }
};

} // namespace autostereo::test
