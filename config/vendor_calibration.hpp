#pragma once

#include "calib/display_profile.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace autostereo::config {

/// Whose calibration file (JSON) it is.
enum class Vendor { LookingGlass, Cubevi };

/// By its keys; nothing where it is neither's, or no JSON.
[[nodiscard]] std::optional<Vendor> vendorOf(std::string_view json);

/// What a user may know better than the importer.
struct ImportChoices {
    std::optional<std::string> base; ///< shipped display; none: by serial, then by panel size
    std::optional<calib::ViewOrder> order;
};

/// A vendor's calibration as the text of a display file.
struct ImportedDisplay {
    std::string base; ///< the shipped display that gives what is not the unit's own
    std::string toml;
    std::vector<std::string> warnings; ///< also under [notes] of the text
};

/// Takes any text; throws ConfigError, one line, where it is wrong. `file` is its name in messages.
[[nodiscard]] ImportedDisplay importDisplay(Vendor vendor, const std::string& file,
                                            std::string_view json,
                                            const ImportChoices& choices = {});

} // namespace autostereo::config
