// A real time-of-flight recording: depth edges, registered, lie on the colour picture's edges.

#include "devices/input.hpp"
#include "gpu/depth_registration.hpp"
#include "tests/support/data.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace autostereo::test {
namespace {

struct GreyPicture {
    int width = 0, height = 0;
    std::vector<double> values;

    [[nodiscard]] double at(int x, int y) const {
        const int pixel = std::clamp(y, 0, height - 1) * width + std::clamp(x, 0, width - 1);
        return values[static_cast<std::size_t>(pixel)];
    }
};

GreyPicture luminance(const devices::Frame& color) {
    GreyPicture grey{color.metadata().width, color.metadata().height, {}};
    const auto bytes = color.pixels();
    for (std::size_t i = 0; i < color.pixelCount(); ++i)
        grey.values.push_back(0.299 * std::to_integer<int>(bytes[4 * i]) +
                              0.587 * std::to_integer<int>(bytes[4 * i + 1]) +
                              0.114 * std::to_integer<int>(bytes[4 * i + 2]));
    return grey;
}

/// How much a picture changes from a pixel to the next along one axis, without sign.
GreyPicture changeAlong(const GreyPicture& grey, int dx, int dy) {
    GreyPicture change{grey.width, grey.height, {}};
    for (int y = 0; y < grey.height; ++y)
        for (int x = 0; x < grey.width; ++x)
            change.values.push_back(std::abs(grey.at(x + dx, y + dy) - grey.at(x, y)));
    return change;
}

/// Pixels between which depth jumps by more than 10 % along one axis.
std::vector<std::array<int, 2>> jumps(const GreyPicture& metres, int dx, int dy) {
    std::vector<std::array<int, 2>> found;
    for (int y = 2; y + 2 < metres.height; ++y)
        for (int x = 2; x + 2 < metres.width; ++x) {
            const double a = metres.at(x, y), b = metres.at(x + dx, y + dy);
            if (a > 0 && b > 0 && std::abs(a - b) > 0.1 * std::min(a, b)) found.push_back({x, y});
        }
    return found;
}

/// Where, from -kReach to kReach pixels along an axis, the colour picture changes most beside the
/// depth edges; to a fraction of a pixel by the parabola through the three best.
struct BestShift {
    double pixels;
    double contrast; ///< the change there, over that at the ends of the search
};

BestShift bestShift(const GreyPicture& metres, const GreyPicture& grey, int dx, int dy) {
    constexpr int kReach = 3;
    const GreyPicture change = changeAlong(grey, dx, dy);
    const auto edges = jumps(metres, dx, dy);
    std::vector<double> sums;
    for (int shift = -kReach; shift <= kReach; ++shift) {
        sums.push_back(0);
        for (const auto& [x, y] : edges)
            sums.back() += change.at(x + shift * dx, y + shift * dy);
    }
    const auto most = std::max_element(sums.begin() + 1, sums.end() - 1);
    const double before = *(most - 1), here = *most, after = *(most + 1);
    return {static_cast<double>(most - sums.begin()) - kReach +
                0.5 * (before - after) / (before - 2 * here + after),
            here / std::max(sums.front(), sums.back())};
}

class RecordingRegistrationGlTest : public GlTest {
  protected:
    void SetUp() override {
        AUTOSTEREO_NEED_DATA("k4a-mug/recording.mkv");
        GlTest::SetUp();
        if (IsSkipped()) return;
        input = devices::openInput(dataDir() / "k4a-mug/recording.mkv");
        depth = std::get<devices::Frame>(input.depth->read(devices::TimePoint::max()));
        color = std::get<devices::Frame>(input.color->read(devices::TimePoint::max()));
    }

    [[nodiscard]] GreyPicture metres(const calib::SensorRig& rig) const {
        const devices::FrameMetadata& form = depth.metadata();
        const gpu::gl::Texture counts(GL_R16UI, form.width, form.height);
        glTextureSubImage2D(counts.name(), 0, 0, 0, form.width, form.height, GL_RED_INTEGER,
                            GL_UNSIGNED_SHORT, depth.depth().data());
        gpu::DepthRegistration pass({}, {}, rig);
        const calib::Intrinsics& picture = rig.color.intrinsics;
        pass.render(counts, form.depthUnitM, picture.width, picture.height);
        std::vector<float> values(color.pixelCount());
        glGetTextureImage(pass.metres().name(), 0, GL_RED, GL_FLOAT,
                          static_cast<GLsizei>(values.size() * sizeof(float)), values.data());
        return {picture.width, picture.height, {values.begin(), values.end()}};
    }

    devices::Input input;
    devices::Frame depth, color;
};

/// Edges of mug, cap and shelf stand before a wall of another brightness, so the picture changes
/// most where their depth jumps. A pixel is what the recording allows: the sensor's own pixel is
/// 1.2 colour pixels wide, and light strays beside the shiny mug (its rim stands out by up to five
/// pixels, hence no wider search).
TEST_F(RecordingRegistrationGlTest, DepthEdgesLieOnColourEdges) {
    if (IsSkipped()) return;
    const GreyPicture grey = luminance(color), aligned = metres(*input.rig);
    for (const auto& [dx, dy] : {std::array{1, 0}, std::array{0, 1}}) {
        const BestShift best = bestShift(aligned, grey, dx, dy);
        std::printf("along %s: %.2f pixels, contrast %.2f\n", dx > 0 ? "x" : "y", best.pixels,
                    best.contrast);
        EXPECT_LT(std::abs(best.pixels), 1);
        EXPECT_GT(best.contrast, 1.3);
    }
    // It would notice: cameras wrong by two pixels.
    calib::SensorRig wrong = *input.rig;
    wrong.color.intrinsics.cx += 2;
    wrong.color.intrinsics.cy -= 2;
    const GreyPicture moved = metres(wrong);
    EXPECT_LT(bestShift(moved, grey, 1, 0).pixels, -1);
    EXPECT_GT(bestShift(moved, grey, 0, 1).pixels, 1);
}

} // namespace
} // namespace autostereo::test
