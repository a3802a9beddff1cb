#include "tests/bench/views/reference.hpp"

#include "tests/oracle/searched_panel.hpp"
#include "tests/support/gl_search_input.hpp"

#include <cmath>
#include <stdexcept>
#include <thread>

namespace autostereo::bench {

gpu::RgbImage referencePanel(const gpu::Pipeline& pipeline, const calib::SensorRig& rig,
                             const calib::DisplayProfile& display, int width, int height,
                             gpu::ViewPositions positions) {
    const calib::PanelMap map = calib::panelMap(display, width, height);
    if (!std::holds_alternative<calib::ViewMap>(map) &&
        !std::holds_alternative<calib::BandMap>(map))
        throw std::invalid_argument("render: --reference: " + display.name +
                                    " is filled with whole views: use --as view");
    const oracle::SearchInput in =
        test::searchInput(rig, pipeline, test::readPicture(pipeline.color()));
    const oracle::SearchedPanel panel(display, width, height, positions,
                                      oracle::channelStepPx(display));
    gpu::RgbImage image{width, height, {}};
    image.pixels.resize(static_cast<std::size_t>(3) * static_cast<std::size_t>(width) *
                        static_cast<std::size_t>(height));
    const unsigned workers = std::max(1U, std::thread::hardware_concurrency());
    const auto work = [&](unsigned worker) {
        for (int y = static_cast<int>(worker); y < height; y += static_cast<int>(workers))
            for (int x = 0; x < width; ++x)
                for (int c = 0; c < 3; ++c)
                    image
                        .pixels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                     static_cast<std::size_t>(x)) +
                                static_cast<std::size_t>(c)] =
                        static_cast<std::uint8_t>(std::lround(panel.level(in, x, y, c)));
    };
    std::vector<std::jthread> threads;
    threads.reserve(workers);
    for (unsigned worker = 0; worker < workers; ++worker)
        threads.emplace_back(work, worker);
    threads.clear();
    return image;
}

} // namespace autostereo::bench
