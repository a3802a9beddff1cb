#include "devices/v4l2/camera_controls.hpp"

#include <linux/videodev2.h>

#include <cerrno>
#include <cstring>

namespace autostereo::devices::v4l2 {

namespace {

constexpr Duration kExposureUnit = std::chrono::microseconds(100); // of V4L2_CID_EXPOSURE_ABSOLUTE

bool has(const VideoNode& node, std::uint32_t id) {
    v4l2_queryctrl about{};
    about.id = id;
    return node.control(VIDIOC_QUERYCTRL, about) == 0 &&
           (about.flags & V4L2_CTRL_FLAG_DISABLED) == 0;
}

/// Sets one after the other and keeps account of what was refused.
class Setter {
  public:
    explicit Setter(const VideoNode& node) : node_(node) {}

    void set(std::uint32_t id, int value, const char* what) {
        v4l2_control control{id, value};
        const int error = node_.control(VIDIOC_S_CTRL, control);
        if (error == 0) return;
        refused_.push_back("v4l2: " + node_.path() + " refuses " + what + ": " +
                           (error == EINVAL ? "it has no such control" : std::strerror(error)));
    }
    /// The same where the camera has the control.
    void offer(std::uint32_t id, int value, const char* what) {
        if (has(node_, id)) set(id, value, what);
    }
    [[nodiscard]] std::vector<std::string> refused() { return std::move(refused_); }

  private:
    const VideoNode& node_;
    std::vector<std::string> refused_;
};

int numberOf(PowerLine line) {
    switch (line) {
    case PowerLine::Off:
        return V4L2_CID_POWER_LINE_FREQUENCY_DISABLED;
    case PowerLine::Hz50:
        return V4L2_CID_POWER_LINE_FREQUENCY_50HZ;
    case PowerLine::Hz60:
        return V4L2_CID_POWER_LINE_FREQUENCY_60HZ;
    case PowerLine::Auto:
        break;
    }
    return V4L2_CID_POWER_LINE_FREQUENCY_AUTO;
}

} // namespace

std::vector<std::string> setControls(const VideoNode& node, const ControlParams& params) {
    Setter setter(node);
    setter.offer(V4L2_CID_EXPOSURE_AUTO_PRIORITY, 0, "a steady frame rate");
    if (params.exposure) {
        setter.set(V4L2_CID_EXPOSURE_AUTO, V4L2_EXPOSURE_MANUAL, "manual exposure");
        setter.set(V4L2_CID_EXPOSURE_ABSOLUTE, static_cast<int>(*params.exposure / kExposureUnit),
                   "that exposure");
    }
    if (params.powerLine)
        setter.set(V4L2_CID_POWER_LINE_FREQUENCY, numberOf(*params.powerLine),
                   "that power line frequency");
    if (params.whiteBalanceK) {
        setter.set(V4L2_CID_AUTO_WHITE_BALANCE, 0, "manual white balance");
        setter.set(V4L2_CID_WHITE_BALANCE_TEMPERATURE, *params.whiteBalanceK, "that white balance");
    }
    return setter.refused();
}

Duration exposureOf(const VideoNode& node) {
    v4l2_control control{V4L2_CID_EXPOSURE_ABSOLUTE, 0};
    if (node.control(VIDIOC_G_CTRL, control) != 0 || control.value <= 0) return Duration(0);
    return control.value * kExposureUnit;
}

} // namespace autostereo::devices::v4l2
