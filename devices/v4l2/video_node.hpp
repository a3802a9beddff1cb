#pragma once

#include "devices/unique_fd.hpp"
#include "devices/v4l2/camera_format.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace autostereo::devices::v4l2 {

/// An open /dev/videoN. Movable, thread-bound.
class VideoNode {
  public:
    /// Throws DeviceError: not there, no permission (with what to do), not a V4L2 device.
    explicit VideoNode(const std::filesystem::path& path);

    /// The kernel's ioctl, again as long as a signal interrupts it. 0, or errno.
    template<class Argument>
    [[nodiscard]] int control(unsigned long request, Argument& argument) const {
        return controlRaw(request, &argument);
    }

    [[nodiscard]] int fd() const { return fd_.get(); }
    [[nodiscard]] const std::string& path() const { return path_; }
    [[nodiscard]] const std::string& card() const { return card_; } ///< the model's name
    [[nodiscard]] const std::string& bus() const { return bus_; }   ///< where it is plugged in
    [[nodiscard]] const std::string& driver() const { return driver_; }
    /// Whether frames can be streamed from it: cameras have further nodes, for metadata.
    [[nodiscard]] bool captures() const { return captures_; }

    /// Every mode with a format that we can show. Empty where the driver lists none. Ranges of
    /// sizes and rates are represented by those that are wanted.
    [[nodiscard]] std::vector<Mode> modes(const ModeRequest& wanted) const;

    /// "v4l2: cannot stream from /dev/video0: VIDIOC_STREAMON: Device or resource busy".
    [[noreturn]] void fail(const char* tried, const char* request, int error) const;

  private:
    [[nodiscard]] int controlRaw(unsigned long request, void* argument) const;
    void addSizes(FourCc code, const ModeRequest& wanted, std::vector<Mode>& modes) const;
    void addPeriods(const Mode& size, const ModeRequest& wanted, std::vector<Mode>& modes) const;

    std::string path_;
    UniqueFd fd_;
    std::string card_, bus_, driver_;
    bool captures_ = false;
};

} // namespace autostereo::devices::v4l2
