#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace autostereo::devices {

/// NumPy arrays on disk (format versions 1 and 2, C order, little-endian). Reentrant.
struct NpyHeader {
    std::string type;               ///< "|u1", "<u2", "<u4", "<f4" or "<f8"
    std::vector<std::size_t> shape; ///< outermost first

    [[nodiscard]] std::size_t elements() const;
    [[nodiscard]] std::size_t bytes() const;
};

struct NpyArray {
    NpyHeader header;
    std::vector<std::byte> data; ///< header.bytes() of them
};

/// Throws std::runtime_error with the file, what it holds and what is allowed; also where it would
/// hold more than `limit` bytes or its size is not what its header says.
[[nodiscard]] NpyArray readNpy(const std::filesystem::path& path, std::size_t limit);
/// The same from memory; `name` for messages.
[[nodiscard]] NpyArray parseNpy(const std::string& name, std::span<const std::byte> file);

/// Writes under a temporary name that becomes `path` only when complete. Throws
/// std::runtime_error.
void writeNpy(const std::filesystem::path& path, const NpyHeader& header,
              std::span<const std::byte> data);

} // namespace autostereo::devices
