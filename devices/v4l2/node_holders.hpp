#pragma once

#include <filesystem>
#include <string>

namespace autostereo::devices::v4l2 {

/// Which other programs have a device node open: "cheese (pid 1234), obs (pid 77)". Empty: none
/// that this user may see. `proc` is where /proc lies; at most a few names, a bounded search.
[[nodiscard]] std::string holdersOf(const std::filesystem::path& node,
                                    const std::filesystem::path& proc = "/proc");

} // namespace autostereo::devices::v4l2
