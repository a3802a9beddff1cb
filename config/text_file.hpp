#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// Where the loaders' text comes from: the disk, or the binary itself. Reentrant.
namespace autostereo::config {

/// The whole file. Throws ConfigError: not there, unreadable, or longer than 1 MiB (no
/// configuration is; protects against being pointed at a device or a recording).
[[nodiscard]] std::string readTextFile(const std::filesystem::path& file);

/// A shipped file by its path below config/, e.g. "displays/preview.toml"; empty if there is none.
[[nodiscard]] std::string_view embeddedText(std::string_view name);
/// Paths of the shipped files that start with `prefix`.
[[nodiscard]] std::vector<std::string> embeddedNames(std::string_view prefix);

} // namespace autostereo::config
