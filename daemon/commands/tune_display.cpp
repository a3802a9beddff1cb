#include "daemon/commands/tune_display.hpp"

#include "calib/solve/display_tuner.hpp"
#include "config/load.hpp"
#include "daemon/commands/display_unit_file.hpp"
#include "daemon/commands/panel_picture.hpp"
#include "daemon/session/pattern_picture.hpp"
#include "daemon/stop_signal.hpp"
#include "daemon/wiring.hpp"
#include "devices/replay/whole_file.hpp"

#include <array>
#include <chrono>
#include <cstdio>
#include <thread>

namespace autostereo::daemon {

namespace {

using calib::TestPattern;

constexpr std::array kPatterns{TestPattern::Lines, TestPattern::Halves, TestPattern::Numbers,
                               TestPattern::Ramps, TestPattern::Colors};
constexpr const char* kHelp = "left right: change, up down: number, page up down: step, p: "
                              "picture, u: undo, t: text, s: save, esc: leave";

/// What is on the panel, and the keys that change it. Thread-bound.
class TuningDesk {
  public:
    TuningDesk(const CalibrateDisplayOptions& options, calib::DisplayProfile display,
               gpu::Panel& panel)
        : options_(options), panel_(panel), tuner_(std::move(display)) {}

    /// Until somebody saves or leaves; whether it was saved.
    bool run(const StopSignal& stop) {
        constexpr std::chrono::milliseconds kPause{10}; // where presenting does not wait
        say(kHelp);
        show();
        while (!saved_ && !panel_.closed() && !stop.requested()) {
            panel_.pollEvents();
            const auto keys = panel_.takeKeys();
            for (const gpu::KeyPress& key : keys)
                press(key);
            if (!keys.empty()) show();
            std::this_thread::sleep_for(kPause);
        }
        return saved_;
    }

  private:
    void press(const gpu::KeyPress& press) {
        using Key = gpu::KeyPress::Key;
        switch (press.key) {
        case Key::Left:
            return change(-1);
        case Key::Right:
            return change(1);
        case Key::Up:
            return tuner_.chooseNext(-1);
        case Key::Down:
            return tuner_.chooseNext(1);
        case Key::PageUp:
            return tuner_.refine(-1);
        case Key::PageDown:
            return tuner_.refine(1);
        case Key::Letter:
            return command(press.letter);
        }
    }

    void command(char letter) {
        if (letter == 'u') tuner_.undo();
        if (letter == 'p') pattern_ = (pattern_ + 1) % kPatterns.size();
        if (letter == 't') text_ = !text_;
        if (letter != 's') return;
        devices::replaceKeepingOld(options_.output, fileText(), "calibrate: ");
        saved_ = true;
    }

    /// A step that no display file may hold is not made.
    void change(int steps) {
        tuner_.change(steps);
        try {
            static_cast<void>(fileText());
        } catch (const config::ConfigError& error) {
            tuner_.undo();
            say(error.what());
        }
    }

    [[nodiscard]] std::string fileText() const {
        return unitFile(options_.display, options_.output,
                        {tuner_.display(), tuner_.changed(), config::MeasuredBy::Eye});
    }

    void show() {
        const std::string now = tuner_.atHand();
        if (now != said_) say(now);
        said_ = now;
        drawPattern(kPatterns.at(pattern_), tuner_.display(), panel_.width(), panel_.height(),
                    panel_.framebuffer());
        if (text_) drawStrip(panel_, now + " | " + kHelp);
        panel_.present();
    }

    static void say(const std::string& line) {
        std::printf("%s\n", line.c_str());
        std::fflush(stdout);
    }

    const CalibrateDisplayOptions& options_;
    gpu::Panel& panel_;
    calibrate::DisplayTuner tuner_;
    std::size_t pattern_ = 0;
    bool text_ = true, saved_ = false;
    std::string said_;
};

} // namespace

int tuneDisplay(const CalibrateDisplayOptions& options) {
    if (!options.photographs.empty())
        throw UsageError("calibrate display: --keys and --photographs are two ways to the same "
                         "numbers: give one");
    config::Config config;
    config.display = options.display;
    const StopSignal stop;
    ChosenDisplay chosen = chooseWindowDisplay(config, false);
    const auto panel =
        openPanel(chosen.profile, config::Output::Window, false, 0, chosen.connector);
    const bool saved = TuningDesk(options, std::move(chosen.profile), *panel).run(stop);
    std::printf("%s\n",
                saved ? ("saved " + options.output.string()).c_str() : "left, nothing saved");
    return saved ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace autostereo::daemon
