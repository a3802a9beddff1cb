#include "config/listen_address.hpp"

#include <charconv>

#include <arpa/inet.h>

namespace autostereo::config {

namespace {

bool isLoopback(const in_addr& address) { return ntohl(address.s_addr) >> 24U == 127; }

std::optional<std::uint16_t> portOf(const std::string& text) {
    std::uint16_t port = 0;
    const char* end = text.data() + text.size();
    const auto [stopped, problem] = std::from_chars(text.data(), end, port);
    if (text.empty() || problem != std::errc() || stopped != end) return std::nullopt;
    return port;
}

} // namespace

std::optional<ListenAddress> listenAddress(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos) return std::nullopt;
    const auto port = portOf(text.substr(colon + 1));
    if (!port) return std::nullopt;
    std::string address = text.substr(0, colon);
    in_addr four{};
    if (inet_pton(AF_INET, address.c_str(), &four) == 1)
        return ListenAddress{std::move(address), *port, isLoopback(four)};
    if (address.size() < 2 || address.front() != '[' || address.back() != ']') return std::nullopt;
    address = address.substr(1, address.size() - 2);
    in6_addr six{};
    if (inet_pton(AF_INET6, address.c_str(), &six) != 1) return std::nullopt;
    return ListenAddress{std::move(address), *port, IN6_IS_ADDR_LOOPBACK(&six) != 0};
}

} // namespace autostereo::config
