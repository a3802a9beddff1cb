#pragma once

#include "config/load.hpp"
#include "daemon/command_line.hpp"
#include "devices/feed.hpp"
#include "devices/input.hpp"
#include "devices/record/recorder.hpp"
#include "devices/record/recording_ring.hpp"
#include "gpu/panel.hpp"

#include <functional>
#include <memory>

namespace autostereo::daemon {

/// A command's options over its configuration file, over the embedded default.
[[nodiscard]] config::Config configuration(const SceneOptions& options);

/// The pipeline's settings where frames go on coming (`live`), or for a single one.
[[nodiscard]] gpu::PipelineParams pipelineParams(const config::Config& config, bool live);

/// The profile that the options or the configuration name, else "preview".
[[nodiscard]] calib::DisplayProfile chooseDisplay(const config::Config& config);
/// A display and the connector of its monitor (the kernel's name; empty: any of its size).
struct ChosenDisplay {
    calib::DisplayProfile profile;
    std::string connector;
};
/// For a window: the display that was asked for, else the one that is recognised, else "preview".
/// What spoils the way to its sub-pixels goes to the log; throws gpu::DisplayNotFound where that
/// mixes views, unless forced.
[[nodiscard]] ChosenDisplay chooseWindowDisplay(const config::Config& config, bool force);
/// To the log, where the profile's numbers are not this unit's own.
void warnOfPlaceholder(const calib::DisplayProfile& display);

/// The input with both streams and a rig; `tap` gets it with the sensor's own streams only.
/// Throws DeviceError, ConfigError.
using Tap = std::function<devices::Input(devices::Input)>;
[[nodiscard]] devices::Input openScene(const config::Config& config, const Tap& tap = {});

/// What records a session's sensors, and what it came to.
class Recording {
  public:
    /// Nothing is recorded without a file, nothing kept in memory without a ring's length; `raw`:
    /// what the device sends below its decoder.
    Recording(std::optional<std::filesystem::path> file, std::optional<std::filesystem::path> raw,
              config::Speed speed, const devices::RingParams& ring);
    /// For the inputs of `config`, none of which may be the file itself. Throws UsageError.
    [[nodiscard]] Tap tap(const config::Config& config);
    /// Closes the file and logs what is in it. After the feed is gone.
    void finish();
    /// Nothing where nothing is recorded.
    [[nodiscard]] std::optional<devices::Recorder::Counters> counters() const;
    /// Why what is recorded below the decoder ended early; empty: it did not.
    [[nodiscard]] std::string rawError() const;

    /// None: nothing is kept.
    [[nodiscard]] const devices::RecordingRing* ring() const { return ring_.get(); }

  private:
    [[nodiscard]] devices::Input begin(devices::Input input);

    std::optional<std::filesystem::path> file_, rawFile_;
    config::Speed speed_;
    std::shared_ptr<devices::Recorder> recorder_;
    std::shared_ptr<devices::RawRecording> raw_;
    std::shared_ptr<devices::RecordingRing> ring_;
};

/// realtime: two sensor threads; max: every frame in order. `clock` must outlive the feed.
[[nodiscard]] std::unique_ptr<devices::Feed> openFeed(devices::Input input,
                                                      const config::Config& config,
                                                      config::Speed speed, bool loop,
                                                      devices::Clock& clock);

/// A window where one was asked for or a display server is there; else off-screen. `connector`, the
/// kernel's name, says which monitor; empty: by size. `refreshHz`: of an off-screen one, 0: none.
/// Throws GlError.
[[nodiscard]] std::unique_ptr<gpu::Panel> openPanel(const calib::DisplayProfile& display,
                                                    config::Output output, bool force,
                                                    double refreshHz = 0,
                                                    const std::string& connector = {});
[[nodiscard]] config::Output chooseOutput(const config::Config& config);

/// The display's own mode, or full HD off-screen where it takes any.
struct PanelSize {
    int width;
    int height;
};
[[nodiscard]] PanelSize offscreenSize(const calib::DisplayProfile& display);

} // namespace autostereo::daemon
