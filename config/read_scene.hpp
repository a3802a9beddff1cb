#pragma once

#include "config/toml_reader.hpp"
#include "gpu/scene/params.hpp"

namespace autostereo::config {

/// [scene]: how mesh content is placed, turned and lit.
void readScene(TomlReader& root, gpu::SceneParams& scene);

} // namespace autostereo::config
