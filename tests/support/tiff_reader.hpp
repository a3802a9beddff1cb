#pragma once

#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace autostereo::test {

/// A TIFF of one strip of 32-bit floats, read by the tags of its first directory.
struct FloatTiff {
    int width = 0, height = 0;
    std::vector<float> samples; ///< top row first
    std::map<int, std::uint32_t> tags;

    [[nodiscard]] double at(int x, int y) const {
        return static_cast<double>(
            samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x)]);
    }
};

/// Throws std::runtime_error where it is no such file.
inline FloatTiff readFloatTiff(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    const auto number = [&](std::size_t at, std::size_t size) {
        if (at + size > bytes.size()) throw std::runtime_error(path + ": too short");
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + at, size);
        return value;
    };
    if (number(0, 4) != 0x002a4949) throw std::runtime_error(path + ": is no TIFF");
    const std::size_t directory = number(4, 4);
    FloatTiff tiff;
    for (std::size_t i = 0; i < number(directory, 2); ++i) {
        const std::size_t field = directory + 2 + 12 * i;
        const bool isShort = number(field + 2, 2) == 3;
        tiff.tags[static_cast<int>(number(field, 2))] = number(field + 8, isShort ? 2 : 4);
    }
    tiff.width = static_cast<int>(tiff.tags.at(256));
    tiff.height = static_cast<int>(tiff.tags.at(257));
    if (tiff.tags.at(258) != 32 || tiff.tags.at(259) != 1 || tiff.tags.at(339) != 3)
        throw std::runtime_error(path + ": holds no plain floats");
    const std::size_t size = tiff.tags.at(279);
    static_cast<void>(number(tiff.tags.at(273) + size - 4, 4));
    tiff.samples.resize(size / sizeof(float));
    std::memcpy(tiff.samples.data(), bytes.data() + tiff.tags.at(273), size);
    return tiff;
}

} // namespace autostereo::test
