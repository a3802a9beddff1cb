#pragma once

#include "config/config.hpp"
#include "daemon/wiring.hpp"
#include "devices/input.hpp"

#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

namespace autostereo::daemon {

/// Opens an input on a thread of its own, again and again until it is there: opening takes as long
/// as a sensor likes. What no waiting mends (an address or a calibration that is wrong) is thrown
/// by `take`. Thread-bound but for its own thread.
class InputOpener {
  public:
    /// `tap` is called on the thread. Waits between attempts as for lost sensors.
    InputOpener(const config::Config& config, Tap tap);

    /// The input, once. Throws ConfigError, AddressError.
    [[nodiscard]] std::optional<devices::Input> take();
    /// Why it is not there yet; empty: nothing has failed.
    [[nodiscard]] std::string problem() const;

  private:
    void run(const std::stop_token& stop);
    [[nodiscard]] bool tryOnce();

    config::Config config_;
    Tap tap_;
    mutable std::mutex mutex_;
    std::condition_variable_any ended_;
    std::optional<devices::Input> input_;
    std::exception_ptr error_;
    std::string problem_;
    std::jthread thread_; // last: it uses all of the above
};

} // namespace autostereo::daemon
