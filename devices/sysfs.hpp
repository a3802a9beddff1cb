#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace autostereo::devices {

/// What the kernel says of devices, in files of one line each. Reentrant.

/// A file's first line, at most 256 characters, control characters as '?'; empty: unreadable.
[[nodiscard]] std::string sysfsLine(const std::filesystem::path& file);
/// The number that a text starts with; 0: none.
[[nodiscard]] int leadingNumber(const std::string& text);

/// Memory that all USB transfers of programs may take together, MiB; 0: no limit. Nothing: unknown.
[[nodiscard]] std::optional<int> usbMemoryMib(const std::filesystem::path& root = "/");

} // namespace autostereo::devices
