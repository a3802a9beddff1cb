#pragma once

#include "devices/input.hpp"
#include "devices/mesh/open_mesh.hpp"
#include "tests/support/scratch_folder.hpp"

#include <cstring>
#include <string>
#include <vector>

namespace autostereo::test {

/// The one line that opening a scene is refused with; empty: it was not refused.
inline std::string refusal(const std::filesystem::path& file,
                           const devices::mesh::MeshLimits& limits = {}) {
    try {
        static_cast<void>(devices::mesh::openMesh(file, limits));
        return {};
    } catch (const devices::DeviceError& error) {
        EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
        return error.what();
    }
}

/// Bytes of numbers, as they lie in memory.
template<class Number>
std::string bytesOf(const std::vector<Number>& numbers) {
    std::string bytes(numbers.size() * sizeof(Number), '\0');
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return bytes;
}

/// A .glb of a document and its binary chunk.
inline std::string glb(std::string json, std::string chunk) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    chunk.resize((chunk.size() + 3) / 4 * 4, '\0');
    const auto word = [](std::size_t value) {
        return bytesOf(std::vector<std::uint32_t>{static_cast<std::uint32_t>(value)});
    };
    return "glTF" + word(2) + word(12 + 8 + json.size() + 8 + chunk.size()) + word(json.size()) +
           "JSON" + json + word(chunk.size()) + std::string("BIN\0", 4) + chunk;
}

} // namespace autostereo::test
