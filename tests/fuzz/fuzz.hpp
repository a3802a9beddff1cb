#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <span>
#include <string_view>

/// What libFuzzer calls with each input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace autostereo::fuzz {

inline std::span<const std::byte> bytesOf(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const std::byte*>(data), size};
}

inline std::string_view textOf(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Ends the run: libFuzzer keeps the input.
inline void require(bool good, std::string_view what) {
    if (good) return;
    std::cerr << "fuzz: " << what << '\n';
    std::abort();
}

/// One line for people, not longer than a terminal's few.
inline void requirePlain(std::string_view message) {
    require(!message.empty() && message.size() < 1000, "a message of a wrong length");
    require(message.find_first_of("\n\r\t\x1b") == std::string_view::npos, "a message of lines");
}

} // namespace autostereo::fuzz
