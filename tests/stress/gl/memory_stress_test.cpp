// Frame after frame the GPU's stages hold the same objects and bytes, and the process does not
// grow.

#include "tests/stress/campaign.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"

#include <unistd.h>

#include <cstdio>
#include <fstream>

namespace autostereo::test {
namespace {

class MemoryStressTest : public GlTest {};

double residentMib() {
    std::int64_t whole = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> whole >> resident;
    return static_cast<double>(resident * sysconf(_SC_PAGESIZE)) / (1024 * 1024);
}

double mib(const gpu::gl::Usage& usage) { return static_cast<double>(usage.bytes) / (1024 * 1024); }

/// A panel and everything that is drawn for it.
class Stages {
  public:
    explicit Stages(const calib::SensorRig& rig)
        : pipeline_({}, rig, display_, display_.width, display_.height) {}
    void show(const devices::RgbdFrame& frame) { pipeline_.render(frame, panel_.name()); }

  private:
    calib::DisplayProfile display_ = smallLensDisplay(2, 1, 24, 32);
    gpu::Pipeline pipeline_;
    gpu::gl::Texture target_{GL_RGBA8, display_.width, display_.height};
    gpu::gl::Framebuffer panel_ = gpu::gl::makeFramebuffer(target_);
};

TEST_F(MemoryStressTest, StaysConstantFrameAfterFrame) {
    if (IsSkipped()) return;
    constexpr std::uint64_t kWarmUp = 100;
    const std::uint64_t frames = campaign(200, 10'000);
    devices::Input input = devices::sim::openSimulation("sim:person?depth=32x24&color=32x18");
    const gpu::gl::Usage before = gpu::gl::usage();
    gpu::gl::Usage warm;
    double residentWarm = 0;
    {
        Stages stages(*input.rig);
        for (std::uint64_t i = 0; i < kWarmUp + frames; ++i) {
            devices::RgbdFrame frame;
            frame.depth = std::get<devices::Frame>(input.depth->read(devices::TimePoint::max()));
            frame.color = std::get<devices::Frame>(input.color->read(devices::TimePoint::max()));
            stages.show(frame);
            if (i + 1 == kWarmUp) {
                warm = gpu::gl::usage();
                residentWarm = residentMib();
            } else if (i >= kWarmUp) {
                ASSERT_EQ(gpu::gl::usage(), warm) << "in frame " << i;
            }
        }
    }
    std::printf("%llu frames: %lld GL objects, %.2f MiB of GPU memory; process %.1f -> %.1f MiB\n",
                static_cast<unsigned long long>(frames), static_cast<long long>(warm.objects),
                mib(warm), residentWarm, residentMib());
    EXPECT_GT(warm.bytes, 0);
    EXPECT_EQ(gpu::gl::usage(), before) << "not all was given back";
    // What the wrappers do not count: 100 bytes a frame lost would be 1 MiB in the long run, 5 kB
    // in the short one. Allocators and llvmpipe's own caches move by some pages.
    EXPECT_LE(residentMib(), residentWarm + 1);
}

/// A camera that changes its size: what was made for the other one is given back.
TEST_F(MemoryStressTest, ChangingSizesGiveBackWhatTheyTook) {
    if (IsSkipped()) return;
    const CapturedPair small = simulate("sim:room?depth=64x48&color=64x36"),
                       large = simulate("sim:room?depth=96x72&color=128x72");
    Stages stages(small.rig);
    std::array<gpu::gl::Usage, 2> first;
    constexpr int kSettled = 4; // each of the uploader's buffers has met both sizes
    for (int round = 0; round < 20; ++round)
        for (const std::size_t size : {0U, 1U}) {
            stages.show(size == 0 ? small.frame : large.frame);
            if (round == kSettled) first[size] = gpu::gl::usage();
            if (round > kSettled) {
                ASSERT_EQ(gpu::gl::usage(), first[size]) << "round " << round;
            }
        }
    EXPECT_GT(first[1].bytes, first[0].bytes);
}

} // namespace
} // namespace autostereo::test
