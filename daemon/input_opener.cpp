#include "daemon/input_opener.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

namespace autostereo::daemon {

InputOpener::InputOpener(const config::Config& config, Tap tap)
    : config_(config), tap_(std::move(tap)),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

std::optional<devices::Input> InputOpener::take() {
    const std::scoped_lock lock(mutex_);
    if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
    return std::exchange(input_, std::nullopt);
}

std::string InputOpener::problem() const {
    const std::scoped_lock lock(mutex_);
    return problem_;
}

void InputOpener::run(const std::stop_token& stop) {
    devices::Duration delay = config_.reconnect.firstDelay;
    while (!stop.stop_requested() && !tryOnce()) {
        std::unique_lock lock(mutex_);
        ended_.wait_for(lock, stop, delay, [] { return false; });
        delay = std::min(2 * delay, config_.reconnect.longestDelay);
    }
}

bool InputOpener::tryOnce() try {
    devices::Input input = openScene(config_, tap_);
    const std::scoped_lock lock(mutex_);
    input_ = std::move(input);
    return true;
} catch (const devices::AddressError&) {
    const std::scoped_lock lock(mutex_);
    error_ = std::current_exception();
    return true;
} catch (const devices::DeviceError& error) {
    const std::scoped_lock lock(mutex_);
    if (problem_ != error.what()) spdlog::warn("input: waiting for it: {}", error.what());
    problem_ = error.what();
    return false;
} catch (...) {
    const std::scoped_lock lock(mutex_);
    error_ = std::current_exception();
    return true;
}

} // namespace autostereo::daemon
