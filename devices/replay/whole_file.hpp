#pragma once

#include <filesystem>
#include <string_view>

namespace autostereo::devices {

/// Writes under a temporary name that becomes `path` only when complete: a file that is there is
/// the whole one. Never replaces what is no plain file (a device). Throws std::runtime_error, whose
/// text begins with `who`.
void writeWhole(const std::filesystem::path& path, std::string_view bytes,
                std::string_view who = "");

/// The same; what was there before is kept as `path`.old. Killed at any moment it leaves either the
/// old file or the new one.
void replaceKeepingOld(const std::filesystem::path& path, std::string_view bytes,
                       std::string_view who = "");

} // namespace autostereo::devices
