#pragma once

#include "config/toml_reader.hpp"
#include "devices/tracking/params.hpp"

#include <filesystem>

namespace autostereo::config {

/// [viewer]: whose eyes a tracked display follows. A trace's relative name starts from `folder`.
void readViewer(TomlReader& root, const std::filesystem::path& folder,
                devices::ViewerParams& viewer);

} // namespace autostereo::config
