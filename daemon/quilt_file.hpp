#pragma once

#include "calib/display_profile.hpp"
#include "calib/picture.hpp"
#include "gpu/atlas.hpp"
#include "gpu/params.hpp"

#include <filesystem>
#include <optional>

namespace autostereo::daemon {

/// What somebody says of a quilt; none: as its name has it.
struct QuiltShape {
    std::optional<int> columns, rows; ///< else of "..._qs8x6a0.75.png"
    std::optional<double> aspect;     ///< of one tile; checked only
    std::optional<int> views;         ///< else columns x rows
};

/// A picture of all views, view 0 bottom left, and where each lies.
struct Quilt {
    calib::Picture picture;
    gpu::AtlasLayout layout;
};

/// Warns where the tiles are not as wide as the shape says. Throws UsageError where it says no
/// tiles or others than fit, std::runtime_error where the file cannot be read.
[[nodiscard]] Quilt readQuilt(const std::filesystem::path& file, const QuiltShape& shape = {});

/// The display with the quilt's number of views, where its glass does not fix that. Throws
/// UsageError where it shows others, or none.
[[nodiscard]] calib::DisplayProfile displayFor(const Quilt& quilt, calib::DisplayProfile display);

/// How a sub-pixel reads the quilt.
struct QuiltFilters {
    gpu::ViewFilter views = gpu::ViewFilter::Nearest;
    std::optional<gpu::TileFilter> texels; ///< none: nearest for nearest, linear for blend
};

/// Fills a panel's framebuffer; `display` as `displayFor` gave it. Throws GlError.
void drawQuilt(const Quilt& quilt, const calib::DisplayProfile& display, int width, int height,
               const QuiltFilters& filters, GLuint framebuffer);

} // namespace autostereo::daemon
