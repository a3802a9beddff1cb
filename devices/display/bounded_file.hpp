#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace autostereo::devices {

/// The whole of a small file, or nothing where it is absent, unreadable, no ordinary file, or
/// longer than `mostBytes`. Never waits: a pipe in the place of a file is refused, not read. The
/// size that a file claims is not asked for, since sysfs and procfs do not know theirs. Reentrant.
[[nodiscard]] std::optional<std::string> readBoundedFile(const std::filesystem::path& file,
                                                         std::size_t mostBytes);

} // namespace autostereo::devices
