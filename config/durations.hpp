#pragma once

#include "config/toml_reader.hpp"
#include "config/units.hpp"

namespace autostereo::config {

/// A number of milliseconds.
[[nodiscard]] inline devices::Duration milliseconds(TomlReader& table, std::string_view key,
                                                    Range range, devices::Duration fallback) {
    const std::chrono::duration<double, std::milli> otherwise = fallback;
    return units::durationFromMs(table.number(key, range, otherwise.count()));
}

} // namespace autostereo::config
