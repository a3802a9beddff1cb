#pragma once

#include "calib/picture.hpp"

#include <filesystem>

namespace autostereo::config {

/// PNG or JPEG, 8 bits a channel. Throws std::runtime_error.
[[nodiscard]] calib::Picture readPicture(const std::filesystem::path& file);

} // namespace autostereo::config
