#include "calib/calibration_pictures.hpp"

#include "calib/srgb.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace autostereo::calib {

namespace {

constexpr int kSquaresOnShortSide = 11; // with half a square of white around them
constexpr glm::dvec2 kCarrier{4, 3};    // cycles over the panel, each way

std::size_t bytes(int width, int height) {
    return 3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

} // namespace

PanelBoard::PanelBoard(const SubpixelLayout& panel)
    : columns(0), rows(0), width_(panel.width), height_(panel.height),
      square_(std::max(2, std::min(panel.width, panel.height) / kSquaresOnShortSide)) {
    const auto inner = [&](int pixels, int parity) {
        const int most = std::max(4, pixels / square_ - 2); // a square of white at either end
        return most % 2 == parity ? most : most - 1;
    };
    columns = inner(width_, 1);
    rows = inner(height_, 0);
    left_ = (width_ - (columns + 1) * square_) / 2;
    top_ = (height_ - (rows + 1) * square_) / 2;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const int shown = panel.upsideDown ? rows - 1 - row : row;
            const int y = top_ + (shown + 1) * square_;
            const double down = panel.upsideDown ? height_ - y : y;
            cornersM.emplace_back((left_ + (column + 1) * square_ - width_ / 2.0) * panel.pixelM,
                                  (height_ / 2.0 - down) * panel.pixelM);
        }
}

std::vector<std::uint8_t> PanelBoard::picture() const {
    std::vector<std::uint8_t> rgb(bytes(width_, height_), 255);
    for (int y = top_; y < top_ + (rows + 1) * square_; ++y)
        for (int x = left_; x < left_ + (columns + 1) * square_; ++x) {
            if (((x - left_) / square_ + (y - top_) / square_) % 2 != 0) continue;
            const std::size_t at = bytes(width_, y) + 3 * static_cast<std::size_t>(x);
            std::fill_n(rgb.begin() + static_cast<std::ptrdiff_t>(at), 3, std::uint8_t{0});
        }
    return rgb;
}

Fringes::Fringes(DisplayOptics assumed, const DisplayProfile& display)
    : assumed_(std::move(assumed)), nominalEye_(0, 0, display.viewingDistanceM),
      panelM_(display.widthM, display.heightM()) {
    assumed_.lenses.correction = {}; // what is linear is what a few numbers can say
}

std::optional<Fringes> Fringes::of(const DisplayProfile& assumed) {
    auto optics = displayOptics(assumed);
    if (!optics) return std::nullopt;
    return Fringes(std::move(*optics), assumed);
}

double Fringes::cycles(const glm::dvec2& panelPoint) const {
    const glm::dvec2 place = panelPoint / panelM_;
    return assumed_.lenses.coordinate(nominalEye_, panelPoint) + kCarrier.x * place.x +
           kCarrier.y * place.y;
}

std::vector<std::uint8_t> Fringes::picture(int step) const {
    const SubpixelLayout& panel = assumed_.subpixels;
    const Srgb srgb;
    std::vector<std::uint8_t> rgb;
    rgb.reserve(bytes(panel.width, panel.height));
    for (int y = 0; y < panel.height; ++y)
        for (int x = 0; x < panel.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double phase =
                    cycles(panel.position(x, y, c)) + static_cast<double>(step) / kSteps;
                rgb.push_back(srgb.level(0.5 + 0.5 * std::cos(2 * std::numbers::pi * phase)));
            }
    return rgb;
}

std::optional<std::vector<std::uint8_t>> calibrationPicture(CalibrationPicture picture,
                                                            const DisplayProfile& assumed) {
    const auto fringes = Fringes::of(assumed);
    if (!fringes) return std::nullopt;
    if (picture == CalibrationPicture::Board) return PanelBoard(*subpixelLayout(assumed)).picture();
    return fringes->picture(static_cast<int>(picture) -
                            static_cast<int>(CalibrationPicture::Fringes1));
}

} // namespace autostereo::calib
