// What it saves to do again only what a frame changes, whole pipeline, CPU time of all threads per
// frame (llvmpipe: the GPU's work is in it), medians; contenders take turns. As a table.
//
// Still scene: two seconds with time-of-flight noise, then measured. Motion: a part of the depth
// picture's columns moves to and fro, the rest is without noise; f is that part and what a ray may
// come upon from beside it, |d| max on either side.

#include "config/load.hpp"
#include "devices/sim/simulation.hpp"
#include "gpu/gl/context.hpp"
#include "gpu/pipeline.hpp"
#include "tests/bench/figures.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace autostereo;
using bench::cpuMs, bench::median;

constexpr int kTwoSeconds = 60, kMeasured = 7; // frames

/// A sensor and the panel it is shown on.
struct Setting {
    std::string depth, display;
    int width = 0, height = 0; ///< of the panel; 0: the display's own
};

devices::Frame next(devices::Source& source) {
    return std::get<devices::Frame>(source.read(devices::TimePoint::max()));
}

calib::DisplayProfile displayOf(const Setting& setting) {
    calib::DisplayProfile display = config::loadDisplay(setting.display);
    if (setting.width > 0) display.width = setting.width;
    if (setting.height > 0) display.height = setting.height;
    return display;
}

/// The pipeline with or without skipping, and its panel.
struct Contender {
    Contender(const calib::SensorRig& rig, const calib::DisplayProfile& display, bool skips)
        : target(GL_RGBA8, display.width, display.height), panel(gpu::gl::makeFramebuffer(target)),
          pipeline(params(skips), rig, display, display.width, display.height) {}
    static gpu::PipelineParams params(bool skips) {
        gpu::PipelineParams params;
        params.color.sigma = 1.5; // the simulated camera's
        params.skipUnchanged = skips;
        return params;
    }
    void draw(const devices::RgbdFrame& frame, bool counts) {
        const double start = cpuMs();
        pipeline.render(frame, panel.name());
        glFinish();
        if (counts) times.push_back(cpuMs() - start);
    }

    gpu::gl::Texture target;
    gpu::gl::Framebuffer panel;
    gpu::Pipeline pipeline;
    std::vector<double> times;
};

/// `frame` gives each pair from its number.
struct Scene {
    std::string name;
    std::function<devices::RgbdFrame(int)> frame;
    calib::SensorRig rig;
    double moving = -1; ///< share of the columns; -1: none on purpose
};

void measure(const Setting& setting, const Scene& scene) {
    const calib::DisplayProfile display = displayOf(setting);
    Contender full(scene.rig, display, false), skipping(scene.rig, display, true);
    gpu::FrameUploader uploader;
    std::vector<double> uploads;
    for (int i = 0; i < kTwoSeconds + kMeasured; ++i) {
        const devices::RgbdFrame frame = scene.frame(i);
        const bool counts = i >= kTwoSeconds;
        if (counts || i < 2) full.draw(frame, counts); // its past makes no difference to its cost
        skipping.draw(frame, counts);
        const double start = cpuMs();
        uploader.upload(frame);
        glFinish();
        if (counts) uploads.push_back(cpuMs() - start);
    }
    const double whole = median(full.times), less = median(skipping.times);
    const double upload = median(uploads) / whole;
    std::printf("| %s, %s | %s | %.1f | %.1f | %.2f %% | %.1f %% |", setting.depth.c_str(),
                setting.display.c_str(), scene.name.c_str(), whole, less, 100 * upload,
                100 * (1 - less / whole));
    if (scene.moving >= 0) {
        const double reach = std::max(display.disparityNear, -display.disparityFar);
        const double dirty =
            scene.moving > 0 ? std::min(scene.moving + 2 * reach, 1.0) : scene.moving;
        std::printf(" f = %.3f: %.1f %% against %.1f %% |\n", dirty, 100 * less / whole,
                    100 * (1.15 * dirty + 0.01 + upload));
    } else {
        std::printf(" |\n");
    }
    std::fflush(stdout);
}

/// A room seen with noise in depth, in colour or in both.
Scene stillRoom(const Setting& setting, const std::string& name, bool colorNoise) {
    const std::string uri = "sim:room?color=640x480&depth=" + setting.depth;
    auto noisy = std::make_shared<devices::Input>(devices::sim::openSimulation(uri));
    auto clean = std::make_shared<devices::Input>(devices::sim::openSimulation(uri + "&noise=off"));
    return {name,
            [=](int) {
                return devices::RgbdFrame{next(*noisy->depth),
                                          next(colorNoise ? *noisy->color : *clean->color)};
            },
            *noisy->rig};
}

/// Columns in the middle come nearer and go back.
Scene moving(const Setting& setting, double share) {
    auto input = std::make_shared<devices::Input>(
        devices::sim::openSimulation("sim:room?color=640x480&noise=off&depth=" + setting.depth));
    return {"motion in " + std::to_string(static_cast<int>(100 * share)) + " % of the columns",
            [=](int i) {
                devices::RgbdFrame frame{next(*input->depth), next(*input->color)};
                const int width = frame.depth.metadata().width;
                const int columns = static_cast<int>(share * width), first = (width - columns) / 2;
                const auto depth = frame.depth.depth();
                for (std::size_t k = 0; k < depth.size(); ++k) {
                    const int x = static_cast<int>(k % static_cast<std::size_t>(width)) - first;
                    if (x >= 0 && x < columns)
                        depth[k] = static_cast<std::uint16_t>(i % 2 == 0 ? 1000 : 1300);
                }
                return frame;
            },
            *input->rig, share};
}

} // namespace

int main(int argc, char** argv) {
    const std::string only = argc > 1 ? argv[1] : ""; // "still", "motion"; else both
    const gpu::gl::SurfacelessContext context(false);
    std::puts("| depth, panel | scene | everything (ms) | skipping (ms) | bare upload | saved | "
              "cost of full, against 1.15 f + 1 % + upload |\n"
              "|---|---|---|---|---|---|---|");
    const std::vector<Setting> settings{{"640x480", "looking-glass-portrait"},
                                        {"512x424", "looking-glass-portrait"},
                                        {"320x288", "slanted-8view-1080p", 960, 540}};
    for (const Setting& setting : settings) {
        if (only == "motion") break;
        measure(setting, stillRoom(setting, "still, noisy depth", false));
        measure(setting, stillRoom(setting, "still, noisy depth and colour", true));
    }
    for (const double share : {0.0, 0.05, 0.1, 0.25, 0.5, 1.0})
        if (only != "still") measure(settings.back(), moving(settings.back(), share));
    return EXIT_SUCCESS;
}
