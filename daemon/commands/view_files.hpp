#pragma once

#include "gpu/atlas.hpp"
#include "gpu/readback.hpp"

#include <filesystem>

namespace autostereo::daemon {

/// The views as they lie in their tiles.
[[nodiscard]] gpu::RgbImage readAtlas(const gpu::Atlas& atlas);
/// Each view as view_00.png and so on in a folder, which is made. Throws std::runtime_error.
void writeViews(const gpu::Atlas& atlas, const std::filesystem::path& folder);

} // namespace autostereo::daemon
