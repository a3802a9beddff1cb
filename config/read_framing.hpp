#pragma once

#include "config/toml_reader.hpp"
#include "gpu/params.hpp"

#include <filesystem>

namespace autostereo::config {

/// The table [framing]: how the cameras are mounted, what of their picture is shown, and what
/// stands in place of what is far. Relative names of pictures start from `folder`.
void readFraming(TomlReader& framing, const std::filesystem::path& folder,
                 gpu::PipelineParams& params);

} // namespace autostereo::config
