#pragma once

#include "calib/optics.hpp"
#include "calib/panel_map.hpp"
#include "gpu/params.hpp"
#include "tests/oracle/first_hit_oracle.hpp"

// What a panel should show: every sub-pixel searched in double precision, at its own place and for
// the eye that its lens or barrier sends it to.

namespace autostereo::oracle {

/// From red to green to blue, pixels, as the display's optics have it.
inline double channelStepPx(const calib::DisplayProfile& display) {
    const auto layout = calib::subpixelLayout(display);
    if (!layout) return 0;
    const auto& offsets = layout->offsetsM.front();
    return (offsets[2].x - offsets[0].x) / 2 / layout->pixelM;
}

class SearchedPanel {
  public:
    /// Displays whose panel is filled by phase or by bands per eye. `stepPx`: from red to green to
    /// blue; tests say it by hand.
    SearchedPanel(const calib::DisplayProfile& display, int width, int height,
                  gpu::ViewPositions positions, double stepPx)
        : display_(display), width_(width), height_(height),
          map_(calib::panelMap(display, width, height)), positions_(positions),
          step_(stepPx / width) {}

    /// Level of a sub-pixel, `across` and `up` pixels beside it: 0..255.
    [[nodiscard]] double level(const SearchInput& in, int x, int y, int c, double across = 0,
                               double up = 0) const {
        const double placeX = (x + 0.5 + across) / width_ + (c - 1) * step_;
        const double placeY = 1 - (y + 0.5 - up) / height_;
        double level = 0;
        for (const double b : eyes(x, y, c))
            level =
                std::max(level, searchedColor(in, b, placeX, placeY)[static_cast<std::size_t>(c)]);
        return level;
    }

  private:
    [[nodiscard]] std::vector<double> eyes(int x, int y, int c) const {
        std::vector<double> found;
        if (const auto* views = std::get_if<calib::ViewMap>(&map_)) {
            const std::uint32_t phase = views->phase(x, y, c), view = views->view(phase);
            if (view == calib::ViewMap::kBlack) return {};
            const bool one = display_.views == 1; // and its eye in the middle
            if (positions_ == gpu::ViewPositions::Continuous && views->remap.empty() && !one)
                found.push_back((views->reversed ? -1 : 1) * (2 * (phase / 4294967296.0) - 1));
            else
                found.push_back(calib::viewPosition(display_, static_cast<int>(view)));
        }
        if (const auto* bands = std::get_if<calib::BandMap>(&map_))
            for (std::size_t eye = 0; eye < bands->eyes.size(); ++eye)
                if (bands->lit(eye, x, y, c))
                    found.push_back(calib::viewPosition(display_, static_cast<int>(eye)));
        return found;
    }

    calib::DisplayProfile display_;
    int width_, height_;
    calib::PanelMap map_;
    gpu::ViewPositions positions_;
    double step_; ///< from red to green to blue, panel widths
};

} // namespace autostereo::oracle
