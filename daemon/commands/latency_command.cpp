#include "daemon/commands/commands.hpp"
#include "daemon/commands/counter_watch.hpp"
#include "daemon/commands/panel_picture.hpp"
#include "daemon/log.hpp"
#include "daemon/session/percentiles.hpp"
#include "daemon/stop_signal.hpp"
#include "daemon/wiring.hpp"
#include "devices/sim/hash.hpp"
#include "devices/sim/panel_watcher.hpp"
#include "gpu/readback.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <iostream>

namespace autostereo::daemon {

namespace {

using namespace std::chrono_literals;
using Milliseconds = std::chrono::duration<double, std::milli>;

constexpr double kSimulatedHz = 60;
constexpr devices::Duration kLongestSearch = 10s;
/// A number stands so long, so that most exposures lie within one; unevenly, because numbers in
/// step with the camera would always be seen at the same age.
constexpr devices::Duration kLeastStood = 50ms, kMostStood = 83ms;
constexpr std::size_t kFewest = 10; // readings that a median is worth stating of

/// The panel, and the made-up camera that has to be told what it shows.
class ChartPanel {
  public:
    ChartPanel(gpu::Panel& panel, devices::sim::PanelWatcher* watcher, devices::Clock& clock)
        : panel_(panel), watcher_(watcher), clock_(clock) {}

    /// When it was swapped.
    devices::TimePoint show(const calib::Picture& picture) {
        drawStretched(panel_, picture);
        std::optional<calib::Picture> seen;
        if (watcher_ != nullptr) seen = shownPicture();
        panel_.present();
        panel_.pollEvents();
        return seen ? watcher_->shown(*seen) : clock_.now();
    }
    [[nodiscard]] bool closed() const { return panel_.closed(); }

  private:
    [[nodiscard]] calib::Picture shownPicture() const {
        const gpu::RgbImage rgb =
            gpu::readFramebuffer(panel_.framebuffer(), panel_.width(), panel_.height());
        calib::Picture picture{rgb.width, rgb.height, {}};
        picture.pixels.reserve(rgb.pixels.size() / 3 * 4);
        for (std::size_t at = 0; at + 2 < rgb.pixels.size(); at += 3)
            picture.pixels.insert(picture.pixels.end(),
                                  {rgb.pixels[at], rgb.pixels[at + 1], rgb.pixels[at + 2], 255});
        return picture;
    }

    gpu::Panel& panel_;
    devices::sim::PanelWatcher* watcher_;
    devices::Clock& clock_;
};

struct Camera {
    std::unique_ptr<devices::Source> source;
    devices::Reopen reopen;
    devices::sim::PanelWatcher* watcher = nullptr;
};

bool isSimulated(const LatencyOptions& options) { return options.camera.starts_with("sim"); }

Camera openCamera(const LatencyOptions& options, devices::Clock& clock) {
    if (isSimulated(options)) {
        auto watcher = std::make_unique<devices::sim::PanelWatcher>(
            devices::sim::watchedPanel(options.camera), clock);
        auto* const seen = watcher.get();
        return {std::move(watcher), {}, seen};
    }
    devices::Input input = devices::openInput(options.camera);
    if (!input.color || !input.colorIsLive)
        throw UsageError("--camera: " + options.camera + " is no live colour camera");
    return {std::move(input.color), std::move(input.reopen.color), nullptr};
}

std::unique_ptr<gpu::Panel> openChartPanel(const LatencyOptions& options,
                                           const config::Config& config) {
    if (isSimulated(options))
        return openPanel(chooseDisplay(config), config::Output::Offscreen, false,
                         config.refreshHz > 0 ? config.refreshHz : kSimulatedHz);
    if (chooseOutput(config) != config::Output::Window)
        throw UsageError("latency: " + options.camera +
                         " sees nothing of a panel off-screen (start it where there is a display, "
                         "or give --camera sim)");
    const ChosenDisplay display = chooseWindowDisplay(config, false);
    return openPanel(display.profile, config::Output::Window, false, 0, display.connector);
}

/// Shows the board until the camera has found it.
void findPanel(ChartPanel& panel, const CounterWatch& watch, const LatencyOptions& options,
               devices::Clock& clock, const StopSignal& stop) {
    const devices::TimePoint end = clock.now() + kLongestSearch;
    while (!watch.found() && !stop.requested() && !panel.closed()) {
        if (clock.now() > end) {
            const devices::SensorStatus camera = watch.camera();
            throw devices::DeviceError(
                "latency: " + options.camera +
                (camera.lastFrame
                     ? " does not see the whole panel upright and sharp (it shows a "
                       "chessboard: turn the camera until all of it is in the picture)"
                     : " gives no pictures" + (camera.reason.empty() ? "" : ": " + camera.reason)));
        }
        panel.show(calib::CounterChart::board());
        clock.sleepUntil(clock.now() + 10ms);
    }
}

/// Number after number; when each was swapped.
std::vector<devices::TimePoint> count(ChartPanel& panel, double seconds, devices::Clock& clock,
                                      const StopSignal& stop) {
    std::vector<devices::TimePoint> swaps;
    const devices::TimePoint end = clock.now() + devices::Duration(std::llround(1e9 * seconds));
    while (clock.now() < end && swaps.size() < calib::CounterChart::kNumbers && !stop.requested() &&
           !panel.closed()) {
        const auto number = static_cast<unsigned>(swaps.size());
        swaps.push_back(panel.show(calib::CounterChart::blocks(number)));
        const double share = devices::sim::uniformFrom(devices::sim::hashBits(1, number));
        clock.sleepUntil(swaps.back() + kLeastStood +
                         std::chrono::duration_cast<devices::Duration>(
                             share * Milliseconds(kMostStood - kLeastStood)));
    }
    return swaps;
}

Percentiles inMs(const std::vector<devices::Duration>& delays) {
    Percentiles samples;
    for (const devices::Duration delay : delays)
        samples.add(Milliseconds(delay).count());
    return samples;
}

nlohmann::json toJson(const devices::PanelDelay& delay, const CounterWatch::Result& read) {
    const auto percentiles = [](const Percentiles& samples) {
        return nlohmann::json{{"p50", samples.at(0.5).value()}, {"p99", samples.at(0.99).value()}};
    };
    return {
        {"readings", delay.toLight.size()},
        {"refused",
         {{"changing", read.changing}, {"unseen", read.unseen}, {"unmatched", delay.unmatched}}},
        {"swap_to_light_ms", percentiles(inMs(delay.toLight))},
        {"swap_to_arrival_ms", percentiles(inMs(delay.toArrival))},
        {"each_within_ms", Milliseconds(delay.longestStood).count() / 2},
        {"delay_between_ms",
         {Milliseconds(delay.least).count(), Milliseconds(delay.most).count()}}};
}

void print(const nlohmann::json& json, const LatencyOptions& options) {
    const auto line = [&](const char* name, const char* what) {
        std::printf("%s: median %.1f ms, 99 %% %.1f ms\n", what,
                    json.at(name).at("p50").get<double>(), json.at(name).at("p99").get<double>());
    };
    const auto refused = [&](const char* why) {
        return json.at("refused").at(why).get<std::size_t>();
    };
    line("swap_to_light_ms", "swap to mid-exposure");
    line("swap_to_arrival_ms", "swap to the camera's picture here");
    std::printf("each to within %.1f ms; ", json.at("each_within_ms").get<double>());
    const double least = json.at("delay_between_ms")[0], most = json.at("delay_between_ms")[1];
    if (least <= most)
        std::printf("all fit a panel that lights up between %.1f and %.1f ms after the swap\n",
                    least, most);
    else
        std::printf("no single delay fits them all: it varies by %.1f ms or more\n", least - most);
    std::printf("%zu readings of %s; refused: %zu while a number changed, %zu unseen, %zu of no "
                "number shown just before\n",
                json.at("readings").get<std::size_t>(), options.camera.c_str(), refused("changing"),
                refused("unseen"), refused("unmatched"));
    std::fflush(stdout);
}

} // namespace

int measureLatency(const LatencyOptions& options) {
    setUpLog("warn");
    SceneOptions scene;
    scene.config = options.config;
    scene.display = options.display;
    const config::Config config = configuration(scene);
    const StopSignal stop;
    devices::SteadyClock clock;
    Camera camera = openCamera(options, clock);
    const auto panel = openChartPanel(options, config);
    ChartPanel chart(*panel, camera.watcher, clock);
    const CounterWatch watch(std::move(camera.source), std::move(camera.reopen), clock);
    findPanel(chart, watch, options, clock, stop);
    const auto swaps = count(chart, options.seconds, clock, stop);
    const CounterWatch::Result read = watch.result();
    const devices::PanelDelay delay = devices::panelDelay(swaps, read.seen);
    if (delay.toLight.size() < kFewest)
        throw devices::DeviceError(
            "latency: only " + std::to_string(delay.toLight.size()) + " of " +
            std::to_string(read.seen.size() + read.changing + read.unseen) + " pictures of " +
            options.camera +
            " can be read (a shorter exposure, more light, a camera that stands "
            "still; " +
            std::to_string(kFewest) + " are needed)");
    const nlohmann::json json = toJson(delay, read);
    if (options.json)
        std::cout << json.dump(2) << '\n';
    else
        print(json, options);
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
