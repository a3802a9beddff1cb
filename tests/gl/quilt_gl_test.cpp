// Quilts on Looking Glass displays, against the vendor's published shader arithmetic as it stands:
// float32 for which view, gamma space for the mix of two.

#include "calib/panel_map.hpp"
#include "gpu/interleaver.hpp"
#include "gpu/quilt_atlas.hpp"
#include "gpu/readback.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace autostereo::test {
namespace {

struct Case {
    const char* name;
    double pitch, slope, center, dpi;
    int width, height, views;
};

void PrintTo(const Case& tested, std::ostream* out) { // NOLINT(readability-identifier-naming)
    *out << tested.name;
}

calib::DisplayProfile displayOf(const Case& tested) {
    calib::LookingGlassCalibration unit;
    unit.pitch = tested.pitch;
    unit.slope = tested.slope;
    unit.center = tested.center;
    unit.dpi = tested.dpi;
    unit.screenWidth = tested.width;
    unit.screenHeight = tested.height;
    calib::DisplayProfile display;
    display.width = tested.width;
    display.height = tested.height;
    display.views = tested.views;
    display.law = unit;
    return display;
}

/// The vendor's 1 - fract(a), clamped, in one kind of number throughout.
template<class Number>
struct VendorShader {
    explicit VendorShader(const Case& tested)
        : width(static_cast<Number>(tested.width)), height(static_cast<Number>(tested.height)),
          pitch(static_cast<Number>(tested.pitch * tested.width / tested.dpi *
                                    std::cos(std::atan(1 / tested.slope)))),
          tilt(static_cast<Number>(tested.height / (tested.width * tested.slope))),
          subpixel(static_cast<Number>(1 / (3.0 * tested.width))),
          center(static_cast<Number>(tested.center)) {}

    Number operator()(int x, int y, int c) const {
        const Number half = Number{1} / 2;
        const Number u = (static_cast<Number>(x) + half) / width;
        const Number v = (height - 1 - static_cast<Number>(y) + half) / height;
        const Number a = (u + static_cast<Number>(c) * subpixel + v * tilt) * pitch - center;
        const Number w = 1 - (a - std::floor(a));
        return std::min(std::max(w, static_cast<Number>(1e-5)), static_cast<Number>(0.999999));
    }
    Number width, height, pitch, tilt, subpixel, center;
};

class Quilt : public GlTest, public testing::WithParamInterface<Case> {
  protected:
    /// One texel a view; each channel of a view at a level of its own.
    static int levelOf(int view, int c) { return (view * 37 + c * 61 + 11) % 256; }

    static gpu::RgbImage shown(const Case& tested, gpu::ViewFilter filter) {
        const gpu::AtlasLayout layout{tested.views, {tested.views, 1, 1, 1}};
        std::vector<std::byte> pixels;
        for (int view = 0; view < tested.views; ++view)
            for (int c = 0; c < 4; ++c)
                pixels.push_back(static_cast<std::byte>(levelOf(view, c)));
        const gpu::Atlas atlas = gpu::quiltAtlas({tested.views, 1, pixels}, layout);
        const auto display = displayOf(tested);
        const gpu::gl::Texture target(GL_RGBA8, tested.width, tested.height);
        const gpu::gl::Framebuffer panel = gpu::gl::makeFramebuffer(target);
        gpu::makeInterleaver(calib::panelMap(display, tested.width, tested.height), tested.width,
                             tested.height, {gpu::TileFilter::Nearest, filter, 0})
            ->render({&atlas, nullptr}, panel.name());
        return gpu::readFramebuffer(panel.name(), tested.width, tested.height);
    }

    /// Calls visit(x, y, c, level shown) for every sub-pixel of every `step`-th row.
    template<class Visit>
    static void forEach(const gpu::RgbImage& image, int step, Visit visit) {
        for (int y = 0; y < image.height; y += step)
            for (int x = 0; x < image.width; ++x)
                for (int c = 0; c < 3; ++c)
                    visit(x, y, c,
                          image.pixels[3 * (static_cast<std::size_t>(y) *
                                                static_cast<std::size_t>(image.width) +
                                            static_cast<std::size_t>(x)) +
                                       static_cast<std::size_t>(c)]);
    }
};

TEST_P(Quilt, NearestMissesOnlyWhereFloat32Does) {
    const Case& tested = GetParam();
    const VendorShader<float> vendor(tested);
    const VendorShader<double> exact(tested);
    std::size_t misses = 0, floatMisses = 0, seen = 0;
    double farthest = 0;
    forEach(shown(tested, gpu::ViewFilter::Nearest), 1, [&](int x, int y, int c, int level) {
        const float position = vendor(x, y, c) * static_cast<float>(tested.views);
        ++seen;
        floatMisses +=
            static_cast<int>(position) != static_cast<int>(exact(x, y, c) * tested.views);
        if (level == levelOf(static_cast<int>(position), c)) return;
        ++misses;
        const double off = std::abs(position - std::round(position));
        farthest = std::max(farthest, off);
    });
    std::printf("%s: %.4f %% in another view than float32, up to %.4f view off a boundary\n",
                tested.name, 100.0 * static_cast<double>(misses) / static_cast<double>(seen),
                farthest);
    // float32 holds a phase of some hundred cycles to 2e-5 .. 2.3e-4 cycle.
    EXPECT_LT(farthest, 0.02);
    // Its own misses against float64, and a handful where both lie on a boundary.
    EXPECT_LE(misses, floatMisses + 10);
    EXPECT_GT(floatMisses, 0U) << "nothing to miss: is anything compared?";
}

TEST_P(Quilt, BlendAgreesToOneLevelButForTheWrap) {
    const Case& tested = GetParam();
    const VendorShader<double> vendor(tested); // float32's own noise is the other test's
    std::size_t off = 0, last = 0;
    forEach(shown(tested, gpu::ViewFilter::Blend), 7, [&](int x, int y, int c, int level) {
        const double position = vendor(x, y, c) * tested.views;
        const int view = static_cast<int>(position);
        const double share = position - view;
        if (view == tested.views - 1) { // where the vendor goes over to view 0, we stay
            ++last;
            off += level != levelOf(view, c);
            return;
        }
        const double mixed = levelOf(view, c) * (1 - share) + levelOf(view + 1, c) * share;
        off += std::abs(level - mixed) > 1;
    });
    EXPECT_EQ(off, 0U);
    EXPECT_GT(last, 0U);
}

const Case kCases[] = {
    {"portrait", 52.56046553048362, -7.1423088016812, 0.47345216539737284, 324, 1536, 2048, 48},
    {"go", 80.73520762926995, -6.62387594309422, 0.9212455662774963, 491, 1440, 2560, 66},
    {"16-inch", 50, -7, 0.5, 283, 3840, 2160, 45},
    {"8k", 38.0546, -7.7, 0, 280, 7680, 4320, 45},
};
std::string nameOf(const testing::TestParamInfo<Case>& tested) {
    std::string name = tested.param.name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Units, Quilt, testing::ValuesIn(kCases), nameOf);

class QuiltPicture : public GlTest {};

/// What floor(picture / count) leaves over lies at the right and at the top.
TEST_F(QuiltPicture, TileZeroIsBottomLeft) {
    constexpr int kWide = 11, kHigh = 8; // 3 x 2 tiles of 3 x 4 (two columns left over)
    std::vector<std::byte> pixels;
    for (int y = 0; y < kHigh; ++y)
        for (int x = 0; x < kWide; ++x)
            for (int c = 0; c < 4; ++c)
                pixels.push_back(static_cast<std::byte>(10 * x + y));
    const gpu::AtlasLayout layout{6, {3, 2, 3, 4}};
    const gpu::Atlas atlas = gpu::quiltAtlas({kWide, kHigh, pixels}, layout);
    const auto image = gpu::readFramebuffer(atlas.framebuffer(), 9, 8);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 9; ++x)
            EXPECT_EQ(image.pixels[3 * static_cast<std::size_t>(y * 9 + x)], 10 * x + y);
}

} // namespace
} // namespace autostereo::test
