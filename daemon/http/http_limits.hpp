#pragma once

#include <chrono>
#include <cstddef>

namespace autostereo::daemon {

/// What one request may cost.
struct HttpLimits {
    std::size_t head = 8192;                              ///< request line and headers, bytes
    std::size_t body = 4096;                              ///< bytes
    std::chrono::milliseconds request{5000};              ///< until it is whole
    std::chrono::milliseconds reply{10'000};              ///< until it is written
    std::chrono::milliseconds answer{5000};               ///< until the program has one
    static constexpr std::size_t kAtOnce = 8;             ///< connections that are served
    static constexpr std::size_t kWaiting = 32;           ///< that wait for one of those to end
    static constexpr std::chrono::milliseconds kBye{200}; ///< for a client to read the last word
};

} // namespace autostereo::daemon
