#include "calib/look.hpp"
#include "daemon/commands/commands.hpp"
#include "daemon/log.hpp"
#include "daemon/picture_files.hpp"
#include "daemon/wiring.hpp"
#include "devices/replay/image_files.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iostream>

namespace autostereo::daemon {

namespace {

calib::DisplayOptics opticsOf(const calib::DisplayProfile& display) {
    if (auto optics = calib::displayOptics(display)) return std::move(*optics);
    throw UsageError("--display: " + display.name + " has no optics that are known (type " +
                     display.type + "): nothing to look through");
}

void checkEye(const glm::dvec3& eye, const calib::LensArray& lenses) {
    if (eye.z > std::max(0.0, lenses.gapM)) return;
    throw UsageError("--eye: Z = " + std::to_string(eye.z) +
                     " is behind the lenses or slits (allowed > " + std::to_string(lenses.gapM) +
                     ')');
}

/// The panel's R, G, B.
std::vector<std::uint8_t> readPanel(const std::filesystem::path& file,
                                    const calib::DisplayProfile& display) {
    devices::ImageReader reader;
    const devices::ImageHeader header = reader.open(file);
    if (header.width != display.width || header.height != display.height)
        throw UsageError("--panel: " + file.string() + " is " + header.size().text() + ", but " +
                         display.name + " has " + std::to_string(display.width) + 'x' +
                         std::to_string(display.height));
    if (header.format != devices::ImageFormat::Rgba8)
        throw UsageError("--panel: " + file.string() + " is 16-bit grey (allowed 8-bit PNG)");
    std::vector<std::byte> pixels(header.bytes());
    reader.decode(pixels);
    return withoutAlpha(pixels);
}

} // namespace

int look(const LookOptions& options) {
    setUpLog("warn");
    const calib::DisplayProfile display = config::loadDisplay(options.display);
    const calib::DisplayOptics optics = opticsOf(display);
    checkEye(options.eye, optics.lenses);
    warnOfPlaceholder(display);
    const calib::LightModel light{options.aperture.value_or(optics.lenses.aperture),
                                  options.crosstalk.value_or(0)};
    const auto panel = readPanel(options.panel, display);
    const calib::EyePicture seen = calib::look(optics, light, options.eye, panel);
    devices::writePng(options.output, {{devices::ImageFormat::Rgb8, display.width, display.height},
                                       std::as_bytes(std::span(seen.rgb))});
    if (options.json)
        std::cout << nlohmann::json{{"display", display.name},
                                    {"eye_m", {options.eye.x, options.eye.y, options.eye.z}},
                                    {"subpixels", panel.size()},
                                    {"lit_subpixels", seen.lit},
                                    {"mean_weight", seen.meanShare},
                                    {"aperture", light.aperture},
                                    {"crosstalk", light.crosstalk},
                                    {"gap_mm", optics.lenses.gapM * 1e3},
                                    {"lens_pitch_mm", optics.lenses.pitchM * 1e3}}
                         .dump(2)
                  << '\n';
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
