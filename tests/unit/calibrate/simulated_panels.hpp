#pragma once

#include "calib/calibration_pictures.hpp"
#include "calib/solve/display_numbers.hpp"
#include "calib/solve/display_solver.hpp"
#include "config/load.hpp"
#include "tests/support/panel_camera.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace autostereo::calibrate {

/// A unit of a model: its numbers off by what units differ in (`share` of it).
inline calib::DisplayProfile unitOf(calib::DisplayProfile model, std::uint32_t seed, double share) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> off(-share, share);
    const auto numbers = measuredNumbers(model);
    // In spans: a few fringes over the panel, any offset, a twentieth of the fan.
    constexpr std::array kSpans{3.0, 3.0, 5.0, 1.0};
    for (std::size_t i = 0; i < numbers.size(); ++i)
        *numbers[i].value += kSpans.at(i) * off(engine) * numbers[i].span;
    return model;
}

/// The unit with its sheet bent by up to `cycles`: a swell over the panel, a dent in a corner.
inline calib::DisplayProfile bent(calib::DisplayProfile unit, double cycles) {
    constexpr int kNodes = 41;
    calib::PhaseGrid& grid = *calib::phaseGrid(unit.law);
    grid = {kNodes, kNodes, {}};
    for (int row = 0; row < kNodes; ++row)
        for (int column = 0; column < kNodes; ++column) {
            const double x = column / (kNodes - 1.0), y = row / (kNodes - 1.0);
            const double swell = 0.5 * std::sin(5 * x + 1) * std::cos(4 * y);
            const double away = std::hypot(x - 0.8, y - 0.25) / 0.15;
            grid.cycles.push_back(cycles * (swell + 0.5 * std::exp(-away * away)));
        }
    return unit;
}

/// Photographs of a panel that shows what `assumed` would have it show, from `places`.
inline std::vector<PanelSight> sightsOf(const calib::DisplayProfile& truth,
                                        const calib::DisplayProfile& assumed,
                                        const std::vector<glm::dvec3>& places,
                                        test::PanelCamera& camera) {
    const auto optics = calib::displayOptics(truth).value();
    const auto shown = calib::displayOptics(assumed).value();
    const calib::PanelBoard board(shown.subpixels);
    const auto fringes = calib::Fringes::of(assumed).value();
    std::vector<std::vector<std::uint8_t>> pictures{board.picture()};
    for (int step = 0; step < calib::Fringes::kSteps; ++step)
        pictures.push_back(fringes.picture(step));
    std::vector<PanelSight> sights;
    for (const glm::dvec3& place : places) {
        camera.place(place, 0.03 * static_cast<double>(sights.size()));
        std::vector<std::vector<std::uint8_t>> photos;
        photos.reserve(pictures.size());
        for (const auto& picture : pictures)
            photos.push_back(camera.photograph(optics, picture));
        const auto image = [&](std::size_t i) {
            const calib::Intrinsics& size = camera.model().intrinsics;
            return ColorImage{size.width, size.height, photos[i]};
        };
        sights.push_back(seePanel(shown.subpixels, camera.model(),
                                  {"place " + std::to_string(sights.size() + 1),
                                   image(0),
                                   {image(1), image(2), image(3)}}));
    }
    return sights;
}

/// Three places from which the whole panel fills most of the picture, within the middle half of
/// the fan, at different heights and distances.
inline std::vector<glm::dvec3> placesFor(const calib::DisplayProfile& display,
                                         const test::PanelCamera& camera) {
    const calib::Intrinsics& lens = camera.model().intrinsics;
    const double near = 1.25 * std::max(lens.fx * display.widthM / lens.width,
                                        lens.fy * display.heightM() / lens.height);
    const double side = std::tan(display.coneRad / 4);
    return {near * glm::dvec3(-side, 0.1, 1.0), near * glm::dvec3(0.2 * side, -0.15, 1.2),
            near * glm::dvec3(side, 0.05, 1.05)};
}

/// Of the phases of two calibrations as an eye in the nominal place meets them, in views, over a
/// grid of places on the panel: the share's quantile.
inline double phaseErrorViews(const calib::DisplayProfile& found,
                              const calib::DisplayProfile& truth, double quantile) {
    const auto is = calib::displayOptics(found).value(), was = calib::displayOptics(truth).value();
    const glm::dvec3 eye(0, 0, truth.viewingDistanceM);
    std::vector<double> errors;
    constexpr int kGrid = 101;
    for (int y = 0; y < kGrid; ++y)
        for (int x = 0; x < kGrid; ++x) {
            const glm::dvec2 place = glm::dvec2(x, y) / (kGrid - 1.0) - 0.5;
            const glm::dvec2 point = place * glm::dvec2(truth.widthM, truth.heightM());
            double off = is.lenses.coordinate(eye, point) - was.lenses.coordinate(eye, point);
            off -= std::round(off);
            errors.push_back(truth.views * std::abs(off));
        }
    std::ranges::sort(errors);
    return errors[static_cast<std::size_t>(quantile * static_cast<double>(errors.size() - 1))];
}

} // namespace autostereo::calibrate
