#pragma once

#include "devices/input.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <thread>

namespace autostereo::test {

/// Waits until something is so, for at most two seconds.
template<class Condition>
[[nodiscard]] bool within2s(const Condition& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(2);
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return true;
}

/// The one stream of an input, with how it is opened again.
struct Stream {
    std::unique_ptr<devices::Source> source;
    devices::Reopen reopen;
    devices::Input input; ///< the rest

    explicit Stream(const std::string& uri) : input(devices::openInput(uri)) {
        const bool depth = input.depth != nullptr;
        source = std::move(depth ? input.depth : input.color);
        reopen = std::move(depth ? input.reopen.depth : input.reopen.color);
    }

    /// The next frame within `patience`; empty where none came, then `lost` may say why.
    devices::Frame next(std::chrono::milliseconds patience = std::chrono::seconds(3)) {
        const auto end = std::chrono::steady_clock::now() + patience;
        lost.clear();
        while (std::chrono::steady_clock::now() < end) {
            auto result = source->read(end);
            if (auto* frame = std::get_if<devices::Frame>(&result)) return std::move(*frame);
            if (const auto* gone = std::get_if<devices::Disconnected>(&result)) {
                lost = gone->reason;
                break;
            }
        }
        return {};
    }
    /// Whether it can be opened again within two seconds; then it is.
    [[nodiscard]] bool opensAgain() {
        return within2s([&] {
            try {
                source = reopen();
                return true;
            } catch (const devices::DeviceError&) {
                return false;
            }
        });
    }
    std::string lost;
};

} // namespace autostereo::test
