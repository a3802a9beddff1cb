#pragma once

#include "devices/display/looking_glass_hid.hpp"

#include <cstddef>
#include <memory>

namespace autostereo::devices {

/// Opens the `index`-th first-generation Looking Glass on USB, counted from 0 in the order of the
/// bus, and takes it from the kernel's own driver until destruction. Nothing: there is none, or no
/// USB at all. Throws DeviceError where it is there but cannot be used, with what to do.
/// Thread-bound; replies block up to their deadline.
[[nodiscard]] std::unique_ptr<HidTransport> openLookingGlassHid(std::size_t index = 0);

} // namespace autostereo::devices
