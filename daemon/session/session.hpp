#pragma once

#include "daemon/input_opener.hpp"
#include "daemon/session/attendance.hpp"
#include "daemon/session/report.hpp"
#include "daemon/session/screen.hpp"
#include "daemon/session/show_policy.hpp"
#include "daemon/session/status.hpp"
#include "daemon/session/viewer.hpp"
#include "daemon/session/watchdog.hpp"
#include "daemon/wiring.hpp"
#include "devices/frame_pool.hpp"

#include <filesystem>
#include <memory>
#include <optional>

namespace autostereo::daemon {

/// One run: frames from the feed to the screen, what is shown where none come, and the accounts of
/// it. Thread-bound.
class Session {
  public:
    /// A picture that stands is presented anew: what is behind a window may have lost it.
    static constexpr std::chrono::milliseconds kStillInterval{500};
    /// What moves by itself has a display's rate, 60 Hz.
    static constexpr std::chrono::milliseconds kPictureInterval{16};

    /// Opens input, display and panel. `sensors` gets every input as it was opened, on any thread,
    /// and gives the one to show. Throws what they throw.
    Session(const RunOptions& options, const config::Config& config, Tap sensors = {});

    /// The next picture, or a short wait for it; false when there is nothing more to show or the
    /// window is closed. Throws what waiting for an input cannot mend.
    [[nodiscard]] bool step();

    /// Sensors stop, the recording ends with what they gave.
    [[nodiscard]] const Report& close();

    /// Depth, method and brightness as `config` has them, from the next picture on.
    void adjust(const config::Config& config);
    /// All of another configuration. Throws ConfigError, DeviceError, and nothing has changed then.
    void replace(const config::Config& config);
    /// A test pattern in place of everything else; none: back to that. Throws UsageError.
    void showPattern(const std::optional<Pattern>& pattern);
    [[nodiscard]] Status status();
    [[nodiscard]] const Report& accounts();
    [[nodiscard]] gpu::RgbImage picture();
    /// The cameras' last pictures; none: they are not kept.
    [[nodiscard]] std::optional<devices::RecordingRing::Held> lastPictures() const;
    /// A small picture for the operator. Throws std::runtime_error where no camera's picture is
    /// shown: what was seen before is not to be taken for what is.
    [[nodiscard]] gpu::RgbImage preview(const PreviewRequest& request);

    /// PNG of what the panel shows. Throws std::runtime_error.
    void writePicture(const std::filesystem::path& file);
    /// Known after `close`.
    [[nodiscard]] bool endedWithoutPicture() const { return endedWithoutPicture_; }
    [[nodiscard]] bool offscreen() const { return output_ == config::Output::Offscreen; }

  private:
    [[nodiscard]] bool finished() const;
    [[nodiscard]] bool waitsForInput() const;
    [[nodiscard]] Tap tap();
    void adopt(devices::Input input);
    void startScene();
    [[nodiscard]] bool stepScene();
    [[nodiscard]] double sceneSeconds() const;
    void waitForInput();
    void takeInput();
    [[nodiscard]] bool isFresh(const devices::RgbdFrame& frame);
    void show(devices::RgbdFrame frame);
    void noteLatency(const devices::RgbdFrame& frame, devices::TimePoint takenAt,
                     devices::TimePoint drawnAt);
    /// Closed or Nobody, where pictures are not wanted now.
    [[nodiscard]] std::optional<Shown> rest() const;
    void showWithoutPair();
    void showColorAlone(devices::Frame color);
    void drawAgain();
    void presentAgain();
    /// What stands is presented anew after a time, and when it looks otherwise by itself.
    void refreshStanding();
    void openViewer();
    void followViewer();
    void present();
    void enter(Shown shown);
    /// The monitor is off while nobody has been there, or it has been closed, for long.
    void powerMonitor();
    void log();
    [[nodiscard]] std::optional<devices::SensorStatuses> sensors() const;

    config::Config config_;
    config::Output output_;
    bool realtime_;
    devices::SteadyClock clock_;
    Tap sensors_;
    Recording recording_;
    std::optional<devices::Input> input_; ///< opened before the panel, until it is adopted
    std::optional<devices::mesh::MeshScene> scene_; ///< in place of an input
    Screen screen_;
    std::unique_ptr<Viewer> viewer_; ///< none: nobody is followed
    devices::TimePoint frameAt_;     ///< of the frame shown, media time at --speed max
    ShowPolicy policy_;
    Attendance attendance_;
    Shown shown_ = Shown::Starting;
    std::string message_;
    std::optional<Pattern> pattern_;
    bool redraw_ = false;
    devices::TimePoint shownSince_, presentedAt_;

    std::unique_ptr<devices::Feed> feed_; ///< none while the input is not there
    std::unique_ptr<InputOpener> opener_; ///< while it is waited for
    devices::FeedCounters before_;        ///< of feeds that are gone
    bool depthIsLive_ = false;            ///< stamped by a sensor
    devices::RgbdFrame last_;             ///< to tell a picture that did not change,
    std::uint64_t timesShown_ = 0;        ///< and how often it was drawn in a row
    bool othersShown_ = false;            ///< unlike the last, since the start
    devices::FramePool flatPool_{2};
    devices::RgbdFrame colorAlone_; ///< flat depth, and the last colour frame without a partner

    Watchdog watchdog_;
    std::optional<std::uint64_t> framesWanted_;
    devices::TimePoint started_, logAt_, ratedAt_;
    std::uint64_t ratedPictures_ = 0;
    double rate_ = 0; ///< live pictures per second, lately
    bool endedWithoutPicture_ = false;
    Report report_;
};

} // namespace autostereo::daemon
