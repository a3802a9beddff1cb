#pragma once

#include "daemon/control/control_desk.hpp"
#include "daemon/session/session.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/staged_sensor.hpp"

#include <array>
#include <chrono>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace autostereo::test {

/// The whole program but its command line, on a small panel without a monitor, with sensors that do
/// what they are told; the pictures that are right are known. Thread-bound.
class Rehearsal {
  public:
    struct Scene {
        std::string input;    ///< URI
        std::size_t pictures; ///< of it, over and over
        std::string record;   ///< file in the folder; "": nothing is recorded
        devices::Duration period = std::chrono::nanoseconds(33'333'333);
    };
    /// Starts it and learns what it shows when nothing is wrong.
    Rehearsal(const ScratchFolder& folder, const Scene& scene);

    /// What was seen since the last `forget`.
    struct Seen {
        std::uint64_t live = 0;    ///< pictures that were called live
        std::uint64_t wrong = 0;   ///< of those, not the one that belongs to their time
        std::uint64_t notLive = 0; ///< steps
        double oldestMs = 0; ///< live picture, since it was captured, but for the step's own time
        double leastPsnrDb = 1000;
        double overdueMs = 0; ///< a live picture's age beyond what is allowed
    };
    /// One step of the session.
    void pass();
    /// The same, and a look at what it shows.
    void step();
    void runFor(std::chrono::milliseconds time);
    /// Until some right pictures have come in a row: when the first of them came. None within the
    /// limit.
    [[nodiscard]] std::optional<std::chrono::milliseconds>
    untilRight(std::chrono::milliseconds limit);
    [[nodiscard]] const Seen& seen() const { return seen_; }
    void forget() { seen_ = {}; }

    [[nodiscard]] SensorOrders& depth() { return depth_; }
    [[nodiscard]] SensorOrders& color() { return color_; }
    [[nodiscard]] daemon::Session& session() { return *session_; }
    [[nodiscard]] daemon::ControlDesk& desk() { return *desk_; }
    [[nodiscard]] std::filesystem::path socket() const { return folder_ / "control.sock"; }
    [[nodiscard]] std::filesystem::path recording() const { return folder_ / scene_.record; }
    /// Writes the configuration file: the usual one and some more lines.
    void configure(const std::string& more = "") const;
    /// Over the socket, while the session goes on.
    void ask(const daemon::ControlRequest& request);
    [[nodiscard]] std::uint64_t answered() const { return answered_; }
    [[nodiscard]] std::uint64_t refused() const { return refused_; }

  private:
    void learn();
    /// The live picture's number in the reel, where a new one is on the panel.
    [[nodiscard]] std::optional<std::size_t> newPicture();
    [[nodiscard]] bool isRight(std::size_t number);
    void noteAge(devices::TimePoint stepBegan, const daemon::Status& status);

    const ScratchFolder& folder_;
    Scene scene_;
    SensorOrders depth_, color_;
    std::unique_ptr<daemon::Session> session_;
    std::unique_ptr<daemon::ControlDesk> desk_;
    std::optional<devices::TimePoint> shown_;      ///< captured then
    std::vector<std::vector<std::uint8_t>> right_; ///< panel by picture of the reel
    std::optional<std::size_t> newest_; ///< picture of the reel; none: no new one in the last step
    bool lastWasRight_ = false;
    devices::TimePoint newestAt_{};               ///< when that was seen,
    std::array<devices::Duration, 2> spacings_{}; ///< since the ones before,
    devices::Duration drawn_{0};                  ///< and how long its step took
    Seen seen_;
    std::uint64_t answered_ = 0, refused_ = 0;
};

} // namespace autostereo::test
