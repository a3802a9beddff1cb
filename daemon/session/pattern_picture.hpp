#pragma once

#include "calib/calibration_pictures.hpp"
#include "calib/test_pattern.hpp"
#include "gpu/gl/api.hpp"

#include <string>
#include <variant>

namespace autostereo::daemon {

/// Something known on the panel: one picture a view, or what `calibrate display` wants
/// photographed.
using Pattern = std::variant<calib::TestPattern, calib::CalibrationPicture>;

/// Throws UsageError, which lists those that there are.
[[nodiscard]] Pattern patternNamed(const std::string& name);
[[nodiscard]] std::string nameOf(const Pattern& pattern);

/// Fills the panel. Throws UsageError for a display that makes its views itself, or whose optics
/// are not known where they would be measured; GlError.
void drawPattern(const Pattern& pattern, const calib::DisplayProfile& display, int width,
                 int height, GLuint framebuffer);

} // namespace autostereo::daemon
