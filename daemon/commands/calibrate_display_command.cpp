#include "calib/solve/display_solver.hpp"
#include "calib/solve/refusal.hpp"
#include "config/load.hpp"
#include "daemon/commands/commands.hpp"
#include "daemon/commands/display_unit_file.hpp"
#include "daemon/commands/tune_display.hpp"
#include "daemon/log.hpp"
#include "daemon/picture_files.hpp"
#include "devices/replay/image_files.hpp"
#include "devices/replay/whole_file.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>

namespace autostereo::daemon {

namespace {

constexpr std::size_t kPerPlace = 1 + calib::Fringes::kSteps;

struct Photograph {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;

    [[nodiscard]] calibrate::ColorImage image() const { return {width, height, rgb}; }
};

Photograph readPhotograph(const std::filesystem::path& file) {
    devices::ImageReader reader;
    const devices::ImageHeader header = reader.open(file);
    if (header.format != devices::ImageFormat::Rgba8)
        throw UsageError("--photographs: " + file.string() +
                         " is 16-bit grey (allowed PNG or JPEG in colour)");
    std::vector<std::byte> pixels(header.bytes());
    reader.decode(pixels);
    return {header.width, header.height, withoutAlpha(pixels)};
}

std::vector<calibrate::PanelSight> sightsIn(const CalibrateDisplayOptions& options,
                                            const calib::SubpixelLayout& panel,
                                            const calib::CameraModel& camera) {
    std::vector<calibrate::PanelSight> sights;
    for (std::size_t first = 0; first < options.photographs.size(); first += kPerPlace) {
        std::vector<Photograph> shots;
        for (std::size_t i = 0; i < kPerPlace; ++i)
            shots.push_back(readPhotograph(options.photographs[first + i]));
        sights.push_back(
            calibrate::seePanel(panel, camera,
                                {options.photographs[first].string(),
                                 shots[0].image(),
                                 {shots[1].image(), shots[2].image(), shots[3].image()}}));
    }
    return sights;
}

nlohmann::json toJson(const calibrate::DisplayCalibration& found) {
    nlohmann::json numbers;
    for (const calibrate::MeasuredNumber& number : found.numbers)
        numbers[number.table + '.' + number.key] = {{"value", number.value},
                                                    {"half95", number.half95}};
    return {{"numbers", numbers},
            {"phase_95_views", found.half95Views},
            {"rms_views", found.rmsViews},
            {"deformation_views", found.deformationViews},
            {"local_views", found.localViews}};
}

void print(const calibrate::DisplayCalibration& found,
           const std::vector<calibrate::PanelSight>& sights) {
    for (const calibrate::PanelSight& sight : sights)
        std::printf("%s: camera at %.3f, %.3f, %.3f m, board %.2f px rms, fringes' contrast %.2f\n",
                    sight.name.c_str(), sight.eye.x, sight.eye.y, sight.eye.z, sight.boardPx,
                    sight.fringes.contrast);
    for (const calibrate::MeasuredNumber& number : found.numbers)
        std::printf("%s.%s = %.10g +- %.2g\n", number.table.c_str(), number.key.c_str(),
                    number.value, number.half95);
    std::printf("phase anywhere on the panel: within %.3f views (95 %%), places disagree by %.3f\n",
                found.half95Views, found.rmsViews);
    const bool grid = !calib::phaseGrid(found.display.law)->cycles.empty();
    std::printf(
        "sheet deformed by %.3f views (95 %% of the panel), %s, %.3f left in single places\n",
        found.deformationViews, grid ? "corrected by a phase grid" : "not corrected",
        found.localViews);
    constexpr double kDeformed = 0.5; // views
    if (found.localViews > kDeformed)
        std::printf("warning: the sheet is deformed in a way that these photographs cannot tell\n");
    std::fflush(stdout);
}

} // namespace

int calibrateDisplay(const CalibrateDisplayOptions& options) {
    setUpLog("warn");
    if (options.output.extension() != ".toml")
        throw UsageError("--output: " + options.output.string() +
                         " is no display file (allowed *.toml)");
    if (options.keys) return tuneDisplay(options);
    if (options.photographs.empty() || options.camera.empty())
        throw UsageError("calibrate display: --camera and --photographs are needed (or --keys)");
    if (options.photographs.size() % kPerPlace != 0)
        throw UsageError("--photographs: " + std::to_string(options.photographs.size()) +
                         " files (allowed four from each place: calibration-board, then "
                         "calibration-fringes-1 to -3)");
    const calib::DisplayProfile assumed = config::loadDisplay(options.display);
    const auto panel = calib::subpixelLayout(assumed);
    if (!panel || !calib::displayOptics(assumed))
        throw UsageError("--display: " + assumed.name + " has no optics that are known (type " +
                         assumed.type + "): nothing to measure");
    const calib::SensorRig rig = config::loadRig(options.camera);
    try {
        const auto sights = sightsIn(options, *panel, rig.color);
        const auto found = calibrate::calibrateDisplay(assumed, sights);
        devices::replaceKeepingOld(
            options.output,
            unitFile(options.display, options.output, {found.display, found.numbers}),
            "calibrate: ");
        if (options.json)
            std::cout << toJson(found).dump(2) << '\n';
        else
            print(found, sights);
    } catch (const calibrate::Refusal& refusal) {
        throw calibrate::Refusal(std::string("calibrate display: ") + refusal.what());
    }
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
