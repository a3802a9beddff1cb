#include "calib/test_pattern.hpp"
#include "daemon/command_words.hpp"
#include "daemon/commands.hpp"
#include "daemon/log.hpp"
#include "daemon/picture_files.hpp"
#include "daemon/wiring.hpp"
#include "gpu/interleaver.hpp"
#include "gpu/offscreen_panel.hpp"
#include "gpu/quilt_atlas.hpp"

namespace autostereo::daemon {

namespace {

const std::map<std::string, calib::TestPattern> kPatterns{{"numbers", calib::TestPattern::Numbers},
                                                          {"colors", calib::TestPattern::Colors},
                                                          {"lines", calib::TestPattern::Lines},
                                                          {"halves", calib::TestPattern::Halves},
                                                          {"ramps", calib::TestPattern::Ramps}};

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

} // namespace

int pattern(const PatternOptions& options) {
    setUpLog("info");
    std::optional<calib::TestPattern> pattern;
    oneOf(pattern, kPatterns, "pattern")(options.name);
    const calib::DisplayProfile display = config::loadDisplay(options.display);
    if (std::holds_alternative<calib::DepthFrame>(display.law))
        throw UsageError("--display: " + display.name + " makes its views itself");
    warnOfPlaceholder(display);

    const PanelSize size = offscreenSize(display);
    gpu::OffscreenPanel panel(size.width, size.height, false);
    const gpu::AtlasLayout layout = gpu::atlasLayout(display, size.width, size.height);
    const auto pixels = draw(*pattern, layout, static_cast<double>(size.width) / size.height);
    const gpu::Atlas atlas = gpu::quiltAtlas({layout.width(), layout.height(), pixels}, layout);
    gpu::makeInterleaver(calib::panelMap(display, size.width, size.height), size.width, size.height,
                         {gpu::TileFilter::Nearest, gpu::ViewFilter::Nearest, 0})
        ->render({&atlas, nullptr}, panel.framebuffer());
    writePicturePng(options.output,
                    gpu::readFramebuffer(panel.framebuffer(), size.width, size.height));
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
