#include "devices/sim/simulation.hpp"

#include "devices/sim/calibration_board.hpp"
#include "devices/sim/color_camera.hpp"
#include "devices/sim/depth_camera.hpp"
#include "devices/sim/hash.hpp"
#include "devices/sim/person.hpp"
#include "devices/sim/placement.hpp"
#include "devices/sim/plugged_source.hpp"
#include "devices/sim/room.hpp"
#include "devices/sim/simulated_source.hpp"
#include "devices/uri.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace autostereo::devices::sim {
namespace {

constexpr int kSmallest = 16;
constexpr int kLargestDepth = 1024;
constexpr int kLargestColor = 4096;
constexpr double kRadians = 3.14159265358979323846 / 180;
/// Colour cameras have a later, longer exposure.
constexpr Duration kColorOffset = std::chrono::milliseconds(4);

struct Size {
    int width;
    int height;
};

Size sizeIn(const Uri& uri, const std::string& key, Size fallback, int largest) {
    const std::string text = uri.value(key);
    if (text.empty()) return fallback;
    Size size{};
    char rest = 0;
    const int fields = std::sscanf(text.c_str(), "%5dx%5d%c", &size.width, &size.height, &rest);
    const auto allowed = [&](int side) { return side >= kSmallest && side <= largest; };
    if (fields != 2 || !allowed(size.width) || !allowed(size.height)) {
        const std::string range = std::to_string(kSmallest) + "x" + std::to_string(kSmallest) +
                                  " to " + std::to_string(largest) + "x" + std::to_string(largest);
        throw AddressError("sim: cannot open " + uri.text + ": " + key + "=" + text +
                           " is no size (allowed WIDTHxHEIGHT from " + range + ")");
    }
    return size;
}

bool noiseIn(const Uri& uri) {
    const std::string text = uri.value("noise");
    if (text.empty() || text == "on") return true;
    if (text == "off") return false;
    throw AddressError("sim: cannot open " + uri.text + ": noise=" + text + " (allowed on, off)");
}

std::string describe(const std::string& scene, Size depth, Size color, double fps) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "simulated scene %s, %dx%d time-of-flight depth, %dx%d colour, %g fps",
                  scene.c_str(), depth.width, depth.height, color.width, color.height, fps);
    return text;
}

calib::CameraModel centred(Size size, double focal, const calib::Distortion& distortion) {
    // Real lenses sit a little off the middle of their sensor: half a percent.
    return {{size.width, size.height, focal, focal, 0.505 * size.width - 0.5,
             0.495 * size.height - 0.5},
            distortion};
}

/// Cameras on cables: there while FOLDER/depth and FOLDER/color are.
void plugIn(Input& input, const std::filesystem::path& folder, const Reopen& depth,
            const Reopen& color) {
    static SteadyClock clock;
    const Duration period = input.nominalPeriod;
    input.reopen.depth = [=] {
        return std::make_unique<PluggedSource>(folder / "depth", depth(), period, Duration{0},
                                               clock);
    };
    input.reopen.color = [=] {
        return std::make_unique<PluggedSource>(folder / "color", color(), period, kColorOffset,
                                               clock);
    };
    input.depth = input.reopen.depth();
    input.color = input.reopen.color();
    input.depthIsLive = input.colorIsLive = true;
}

} // namespace

std::unique_ptr<Scene> makeScene(const std::string& name, std::uint64_t seed) {
    const auto textures = static_cast<std::uint32_t>(hashBits(seed, 0));
    if (name == "room") return std::make_unique<Scene>(furnishedRoom(textures));
    if (name == "person") return std::make_unique<Scene>(furnishedRoom(textures), personAt);
    if (name == "calibration-board") {
        return std::make_unique<Scene>(emptyRoom({196, 200, 206}, textures), [](double time) {
            return std::vector<Body>{boardAt(time)};
        });
    }
    throw AddressError("sim: no scene '" + name + "' (allowed room, person, calibration-board)");
}

calib::SensorRig simulatedRig(int depthWidth, int depthHeight, int colorWidth, int colorHeight) {
    calib::Distortion depthLens{0.52, -0.019, 3e-5, -6e-5, -0.0025, 0.86, 0.083, -0.013, 1.7};
    const calib::Distortion colorLens{0.075, -0.130, 4e-4, -3e-4, 0.045};
    const auto focalFor = [](const calib::Distortion& lens, double halfPixels, double halfAngle) {
        return halfPixels / calib::distort(lens, {std::tan(halfAngle), 0}).x;
    };
    const double depthFocal = std::max(focalFor(depthLens, 0.5 * depthWidth, 37.5 * kRadians),
                                       focalFor(depthLens, 0.5 * depthHeight, 32.5 * kRadians));
    const double colorFocal = focalFor(colorLens, 0.5 * colorWidth, 40.0 * kRadians);
    calib::SensorRig rig;
    rig.depth = centred({depthWidth, depthHeight}, depthFocal, depthLens);
    rig.color = centred({colorWidth, colorHeight}, colorFocal, colorLens);
    rig.colorFromDepth = {turn(2.0 * kRadians, glm::normalize(glm::dvec3(1.0, 0.25, 0.1))),
                          {-0.040, -0.003, 0.004}};
    rig.provenance = "simulated (exact)";
    return rig;
}

Input openSimulation(const std::string& text) {
    const Uri uri = parseUri(text);
    uri.allowOnly({"seed", "fps", "depth", "color", "noise", "frames", "plug", "color_late_ms"});
    constexpr double kMostFrames = 1e12, kMostSeed = 1e15;
    const auto seed = static_cast<std::uint64_t>(uri.number("seed", 1, 0, kMostSeed));
    const double fps = uri.number("fps", 30, 1, 240);
    const Size depth = sizeIn(uri, "depth", {320, 288}, kLargestDepth);
    const Size color = sizeIn(uri, "color", {1280, 720}, kLargestColor);
    const bool noise = noiseIn(uri);
    FrameTiming timing{fps, Duration(0), std::nullopt};
    if (!uri.value("frames").empty()) {
        timing.frames = static_cast<std::uint64_t>(uri.number("frames", 0, 1, kMostFrames));
    }
    const std::shared_ptr<const Scene> scene = makeScene(uri.path, seed);
    const calib::SensorRig rig = simulatedRig(depth.width, depth.height, color.width, color.height);

    Input input;
    input.uri = text;
    input.description = describe(uri.path, depth, color, fps);
    input.rig = rig;
    input.nominalPeriod = timing.at(1).time_since_epoch();
    const Reopen depthCamera = [=] {
        return std::make_unique<SimulatedSource>(
            std::make_unique<DepthCamera>(scene, rig.depth, rig.colorFromDepth, hashBits(seed, 1),
                                          noise),
            timing);
    };
    FrameTiming later = timing;
    later.offset = kColorOffset;
    constexpr double kLatestMs = 100;
    later.stampedLate =
        std::chrono::duration_cast<Duration>(std::chrono::duration<double, std::milli>(
            uri.number("color_late_ms", 0, -kLatestMs, kLatestMs)));
    const Reopen colorCamera = [=] {
        return std::make_unique<SimulatedSource>(
            std::make_unique<ColorCamera>(scene, rig.color, calib::RigidTransform{},
                                          hashBits(seed, 2), noise),
            later);
    };
    if (const std::string folder = uri.value("plug"); !folder.empty()) {
        plugIn(input, folder, depthCamera, colorCamera);
        return input;
    }
    input.depth = depthCamera();
    input.color = colorCamera();
    return input;
}

} // namespace autostereo::devices::sim
