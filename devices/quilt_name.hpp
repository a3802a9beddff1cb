#pragma once

#include <optional>
#include <string>

namespace autostereo::devices {

/// What a quilt's file name says of it: "castle_qs8x6a0.75.png" has 8 columns and 6 rows of views
/// that are 0.75 as wide as high.
struct QuiltName {
    int columns = 0;
    int rows = 0;
    std::optional<double> aspect;
};

/// The last "_qsCxR" or "_qsCxRaA" in the name; nothing where it has none or its numbers are none.
[[nodiscard]] std::optional<QuiltName> quiltName(const std::string& file);

} // namespace autostereo::devices
