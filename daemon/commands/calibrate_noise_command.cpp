#include "calib/depth_noise.hpp"
#include "config/phrases.hpp"
#include "config/units.hpp"
#include "daemon/commands/commands.hpp"
#include "daemon/log.hpp"
#include "daemon/wiring.hpp"
#include "devices/replay/whole_file.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <iostream>
#include <vector>

namespace autostereo::daemon {

namespace {

using Json = nlohmann::ordered_json;
namespace units = config::units;

/// Copies, because a source has few slots.
struct Recorded {
    int width = 0, height = 0;
    double depthUnitM = 0;
    std::vector<std::vector<std::uint16_t>> depth, amplitude;

    [[nodiscard]] std::vector<calib::StillFrame> frames() const {
        std::vector<calib::StillFrame> views;
        views.reserve(depth.size());
        for (std::size_t i = 0; i < depth.size(); ++i)
            views.push_back({depth[i], amplitude[i]});
        return views;
    }
    [[nodiscard]] bool hasAmplitude() const { return !amplitude.empty() && !amplitude[0].empty(); }
};

/// Up to `most` depth frames of the first one's size and unit.
Recorded record(devices::Source& source, std::uint64_t most) {
    Recorded recorded;
    recorded.depth.reserve(most);
    recorded.amplitude.reserve(most);
    while (recorded.depth.size() < most) {
        const auto read = source.read(devices::TimePoint::max());
        const auto* frame = std::get_if<devices::Frame>(&read);
        if (frame == nullptr) break;
        const devices::FrameMetadata& form = frame->metadata();
        if (recorded.depth.empty()) {
            recorded.width = form.width;
            recorded.height = form.height;
            recorded.depthUnitM = form.depthUnitM;
        }
        if (form.width != recorded.width || form.height != recorded.height) break;
        recorded.depth.emplace_back(frame->depth().begin(), frame->depth().end());
        recorded.amplitude.emplace_back(frame->amplitude().begin(), frame->amplitude().end());
    }
    return recorded;
}

std::string formatted(const char* form, double number) {
    std::array<char, 96> text{};
    std::snprintf(text.data(), text.size(), form, number);
    return text.data();
}

std::string residual(std::optional<double> share) {
    return share ? formatted("residual %.1f %%", 100 * *share)
                 : std::string("not measured here, the default");
}

/// A configuration file, the residuals as its comments.
std::string configuration(const calib::NoiseFit& fit, const std::string& input,
                          std::size_t frames) {
    const auto millimetres = [](double metres) {
        return formatted("%.4g", units::mmFromMetres(metres));
    };
    return "# Depth noise, measured by autostereo calibrate noise from " + std::to_string(frames) +
           " frames of\n# " + config::oneLine(input) +
           "\n[condition]\nnoise_floor_mm = " + millimetres(fit.noise.floorM) +
           "\n# by amplitude: " + residual(fit.amplitudeResidual) +
           "\nnoise_shot_mm = " + millimetres(fit.noise.shotM) +
           "\n# by range: " + residual(fit.rangeResidual) +
           "\nnoise_growth_mm = " + millimetres(fit.noise.growthPerM) + "\n";
}

void printTable(const calib::NoiseFit& fit) {
    std::cout << "by amplitude (" << residual(fit.amplitudeResidual) << ")\n";
    for (const double counts : {50, 100, 200, 500, 1000, 2000, 5000})
        std::printf("%8.0f counts %8.2f mm\n", counts,
                    units::mmFromMetres(fit.noise.sigmaAtAmplitudeM(counts)));
    std::cout << std::flush << "by range (" << residual(fit.rangeResidual) << ")\n" << std::flush;
    for (const double metres : {0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 5.0})
        std::printf("%8.1f m      %8.2f mm\n", metres,
                    units::mmFromMetres(fit.noise.sigmaAtRangeM(metres)));
    std::fflush(stdout);
}

Json toJson(const calib::NoiseFit& fit, std::size_t frames) {
    const auto orNull = [](std::optional<double> number) {
        return number ? Json(*number) : Json(nullptr);
    };
    return {{"frames", frames},
            {"noise_floor_mm", units::mmFromMetres(fit.noise.floorM)},
            {"noise_shot_mm", units::mmFromMetres(fit.noise.shotM)},
            {"noise_growth_mm", units::mmFromMetres(fit.noise.growthPerM)},
            {"amplitude_residual", orNull(fit.amplitudeResidual)},
            {"range_residual", orNull(fit.rangeResidual)}};
}

} // namespace

int calibrateNoise(const CalibrateNoiseOptions& options) {
    if (options.output.extension() != ".toml")
        throw UsageError("--output: " + options.output.string() +
                         " is no configuration file (allowed *.toml)");
    SceneOptions scene;
    scene.input = options.input;
    scene.rig = options.rig;
    const config::Config config = configuration(scene);
    setUpLog("warn");
    const devices::Input input = openScene(config);
    const Recorded recorded = record(*input.depth, options.frames);
    const auto fit = calib::measureDepthNoise(recorded.frames(), recorded.depthUnitM);
    if (!fit)
        throw devices::DeviceError(
            "calibrate noise: cannot measure the noise of " + options.input + ": " +
            std::to_string(recorded.depth.size()) +
            " frames show too few pixels that differ (needs 3 of a scene in which nothing moves, "
            "with noise)");
    devices::writeWhole(options.output, configuration(*fit, options.input, recorded.depth.size()),
                        "calibrate noise: ");
    if (options.json)
        std::cout << toJson(*fit, recorded.depth.size()).dump(2) << '\n';
    else
        printTable(*fit);
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
