#pragma once

#include "calib/sensor_rig.hpp"
#include "daemon/session/idle_content.hpp"
#include "devices/clock.hpp"
#include "devices/feed.hpp"
#include "gpu/pipeline.hpp"

#include <memory>
#include <optional>

namespace autostereo::daemon {

/// A recording of cameras, over and over at its own pace. Nobody takes its pictures for live ones:
/// it has a feed of its own, whose frames are counted and recorded nowhere. Thread-bound.
class IdleRecording final : public IdleContent {
  public:
    explicit IdleRecording(const config::Config& config);

    [[nodiscard]] bool moves() const override { return true; }
    [[nodiscard]] bool advance(double seconds) override;
    void draw(double seconds, const StandingTarget& target) override;
    void replace(const config::Config& config) override;
    void leave() override;

  private:
    void play();
    void takeNewest(std::chrono::milliseconds wait);

    config::Config config_; ///< whose input is the recording
    devices::SteadyClock clock_;
    std::optional<calib::SensorRig> rig_;
    std::unique_ptr<devices::Feed> feed_; ///< this and the pipeline: none while nobody sees it
    devices::RgbdFrame newest_;           ///< empty: nothing came yet
    bool prepared_ = false;               ///< the pipeline has seen it
    std::optional<gpu::Pipeline> pipeline_;
};

} // namespace autostereo::daemon
