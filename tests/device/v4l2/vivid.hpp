#pragma once

#include <cstdint>
#include <string>

namespace autostereo::test {

/// The kernel's test pattern camera, /dev/video0 of the guest, through a second opening of its
/// node: its test controls by the names that it gives them.
class Vivid {
  public:
    static constexpr const char* kNode = "/dev/video0";
    /// What bind and unbind want to know.
    static constexpr const char* kDriver = "/sys/bus/platform/drivers/vivid/";

    /// Whether this is the guest: it has a vivid.
    [[nodiscard]] static bool there();

    /// Buttons are pressed by any value. Throws std::runtime_error where there is no such control.
    static void set(const std::string& control, std::int64_t value);
    /// Everything that an earlier test may have left behind; bars without text on them.
    static void reset();

    /// Hot unplug and plug.
    static void unbind();
    static void bind();
};

} // namespace autostereo::test
