#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace autostereo::config {

/// Where a server listens: an address in digits and a TCP port.
struct ListenAddress {
    std::string address;    ///< "127.0.0.1", "::1"
    std::uint16_t port = 0; ///< 0: any free one
    bool loopback = true;   ///< only this machine can reach it

    [[nodiscard]] bool operator==(const ListenAddress&) const = default;
};

/// "127.0.0.1:8787" or "[::1]:8787"; none where it is neither. Reentrant.
[[nodiscard]] std::optional<ListenAddress> listenAddress(const std::string& text);

} // namespace autostereo::config
