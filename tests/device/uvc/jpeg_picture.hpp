#pragma once

#include "tests/device/usbip/bytes.hpp"

namespace autostereo::test {

/// A JPEG of fine coloured pattern, as heavy as a camera's; `seed` makes others of it. Both sides
/// even. Throws std::runtime_error.
[[nodiscard]] usbip::Bytes jpegPicture(int width, int height, unsigned seed);

} // namespace autostereo::test
