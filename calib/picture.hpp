#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace autostereo::calib {

/// 8-bit R, G, B, 255, gamma-encoded, top row first; 0x0: none.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> pixels;

    [[nodiscard]] bool operator==(const Picture&) const = default;
    [[nodiscard]] bool empty() const { return pixels.empty(); }
    [[nodiscard]] std::size_t offset(int x, int y) const {
        return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x));
    }
};

} // namespace autostereo::calib
