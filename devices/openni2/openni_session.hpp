#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

struct OniCallbackHandleImpl;

namespace autostereo::devices::openni2 {

struct FoundDevice {
    std::string uri;
    std::string vendor;
    std::string name;
    std::uint16_t usbVendor = 0; ///< 0: no USB device, or its driver does not say
    std::uint16_t usbProduct = 0;
};

/// The library's reason for what failed last, one line.
[[nodiscard]] std::string lastReason();

/// The OpenNI2 library, loaded with its drivers (a USB scan: a quarter of a second) while anybody
/// uses it. Loading moves the process to other folders for a moment. Thread-safe.
class Session {
  public:
    /// The one of this process. Throws DeviceError.
    [[nodiscard]] static std::shared_ptr<Session> get();
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    [[nodiscard]] std::vector<FoundDevice> devices() const;
    /// Counts a device about to be opened, until `leave` with the same two values. Returns how
    /// often it was lost so far. Nothing while it is still open from before it was lost: the
    /// library would lend that one again, whose streams are silent.
    [[nodiscard]] std::optional<std::uint64_t> enter(const std::string& uri);
    void leave(const std::string& uri, std::uint64_t losses);
    /// How often the device was lost or broken so far: streams of a lost device only fall silent.
    [[nodiscard]] std::uint64_t losses(const std::string& uri) const;

  private:
    Session();
    void noteLoss(const char* uri);

    mutable std::mutex mutex_;
    std::map<std::string, std::uint64_t> losses_;
    std::multimap<std::string, std::uint64_t> open_; ///< with their losses when they were opened
    OniCallbackHandleImpl* callbacks_ = nullptr;
};

} // namespace autostereo::devices::openni2
