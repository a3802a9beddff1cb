#pragma once

#include "calib/solve/counter_reader.hpp"
#include "devices/doorbell.hpp"
#include "devices/input.hpp"
#include "devices/panel_delay.hpp"
#include "devices/source_thread.hpp"

#include <mutex>
#include <thread>

namespace autostereo::daemon {

/// Looks at a panel through a camera: finds it while it shows the chart's board, from then on reads
/// its numbers. On a thread of its own; what it gives may be asked for on any.
class CounterWatch {
  public:
    struct Result {
        std::vector<devices::SeenNumber> seen;
        std::size_t changing = 0, unseen = 0; ///< refused
    };

    CounterWatch(std::unique_ptr<devices::Source> camera, devices::Reopen reopen,
                 devices::Clock& clock);

    [[nodiscard]] bool found() const;
    [[nodiscard]] devices::SensorStatus camera() const { return source_.status(); }
    [[nodiscard]] Result result() const;

  private:
    void run(const std::stop_token& stop);
    void look(const devices::Frame& frame);

    devices::FrameQueue<devices::Frame> queue_;
    devices::Doorbell bell_;
    mutable std::mutex mutex_; ///< of the two below
    std::optional<calibrate::CounterReader> reader_;
    Result result_;
    devices::SourceThread source_;
    std::jthread thread_; // last: it uses all of the above
};

} // namespace autostereo::daemon
