#pragma once

#include "config/config.hpp"
#include "config/toml_reader.hpp"

#include <filesystem>

namespace autostereo::config {

/// [control], [http], [idle], [rest] and [messages]: what a program that runs for months needs
/// beside its picture. Files that they name are looked for in `folder`.
void readService(TomlReader& root, const std::filesystem::path& folder, Config& config);

} // namespace autostereo::config
