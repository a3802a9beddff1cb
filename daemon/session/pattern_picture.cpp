#include "daemon/session/pattern_picture.hpp"

#include "daemon/command_words.hpp"
#include "gpu/interleaver.hpp"
#include "gpu/picture_blit.hpp"
#include "gpu/quilt_atlas.hpp"

namespace autostereo::daemon {

namespace {

using calib::CalibrationPicture;
using calib::TestPattern;

const std::map<std::string, Pattern> kPatterns{
    {"numbers", TestPattern::Numbers},
    {"colors", TestPattern::Colors},
    {"lines", TestPattern::Lines},
    {"halves", TestPattern::Halves},
    {"ramps", TestPattern::Ramps},
    {"calibration-board", CalibrationPicture::Board},
    {"calibration-fringes-1", CalibrationPicture::Fringes1},
    {"calibration-fringes-2", CalibrationPicture::Fringes2},
    {"calibration-fringes-3", CalibrationPicture::Fringes3}};

/// All views' pictures as a quilt, RGBA, top row first.
std::vector<std::byte> draw(calib::TestPattern pattern, const gpu::AtlasLayout& layout,
                            double aspect) {
    const int tileWidth = layout.quilt.tileWidth, tileHeight = layout.quilt.tileHeight;
    std::vector<std::byte> pixels(4 * static_cast<std::size_t>(layout.width()) *
                                  static_cast<std::size_t>(layout.height()));
    for (int view = 0; view < layout.views; ++view)
        for (int y = 0; y < tileHeight; ++y)
            for (int x = 0; x < tileWidth; ++x) {
                const auto color =
                    calib::patternColor(pattern, view, layout.views, aspect, (x + 0.5) / tileWidth,
                                        (y + 0.5) / tileHeight);
                const auto row =
                    static_cast<std::size_t>(layout.height() - 1 - layout.bottom(view) - y);
                const std::size_t at = 4 * (row * static_cast<std::size_t>(layout.width()) +
                                            static_cast<std::size_t>(layout.left(view) + x));
                for (std::size_t c = 0; c < 3; ++c)
                    pixels[at + c] = std::byte{color.at(c)};
            }
    return pixels;
}

void drawViews(TestPattern pattern, const calib::DisplayProfile& display, int width, int height,
               GLuint framebuffer) {
    if (std::holds_alternative<calib::DepthFrame>(display.law))
        throw UsageError("--display: " + display.name + " makes its views itself");
    const gpu::AtlasLayout layout = gpu::atlasLayout(display, width, height);
    const auto pixels = draw(pattern, layout, static_cast<double>(width) / height);
    const gpu::Atlas atlas = gpu::quiltAtlas({layout.width(), layout.height(), pixels}, layout);
    gpu::makeInterleaver(calib::panelMap(display, width, height), width, height,
                         {gpu::TileFilter::Nearest, gpu::ViewFilter::Nearest, 0})
        ->render({&atlas, nullptr}, framebuffer);
}

void drawPicture(CalibrationPicture picture, const calib::DisplayProfile& display,
                 GLuint framebuffer) {
    const auto rgb = calib::calibrationPicture(picture, display);
    if (!rgb)
        throw UsageError("--display: " + display.name + " has no optics that are known (type " +
                         display.type + "): nothing to measure");
    gpu::blitPicture({display.width, display.height, GL_RGB, *rgb}, framebuffer,
                     {0, display.height, display.width});
}

} // namespace

Pattern patternNamed(const std::string& name) {
    std::optional<Pattern> pattern;
    oneOf(pattern, kPatterns, "pattern")(name);
    return *pattern;
}

std::string nameOf(const Pattern& pattern) {
    for (const auto& [name, kind] : kPatterns)
        if (kind == pattern) return name;
    return {};
}

void drawPattern(const Pattern& pattern, const calib::DisplayProfile& display, int width,
                 int height, GLuint framebuffer) {
    if (const auto* picture = std::get_if<CalibrationPicture>(&pattern))
        drawPicture(*picture, display, framebuffer);
    else
        drawViews(std::get<TestPattern>(pattern), display, width, height, framebuffer);
}

} // namespace autostereo::daemon
