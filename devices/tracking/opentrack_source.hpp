#pragma once

#include "devices/frame_queue.hpp"
#include "devices/tracking/eye_source.hpp"
#include "devices/tracking/params.hpp"
#include "devices/unique_fd.hpp"

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

namespace autostereo::devices {

/// Head poses as opentrack sends them over UDP (opentrack_packet.hpp), stamped on arrival. A thread
/// of its own reads; at most 500 samples a second are of use, of more the newest wins. However many
/// come, it takes 32 datagrams and then rests for 2 ms; the kernel holds some twenty, and drops
/// what is more. Listens on one address: other machines reach it only where that is not loopback.
class OpentrackSource final : public EyeSource {
  public:
    /// `address`: IPv4 in digits; port 0: any free one. `clock` must outlive it. Throws
    /// DeviceError.
    OpentrackSource(const std::string& address, std::uint16_t port, const ViewerParams& params,
                    const glm::dvec3& nominal, Clock& clock);
    [[nodiscard]] std::optional<EyeSample> next(TimePoint now) override;
    [[nodiscard]] bool isLive() const noexcept override { return true; }
    [[nodiscard]] EyeCounters counters() const noexcept override;
    /// The one it listens on.
    [[nodiscard]] std::uint16_t port() const { return port_; }

  private:
    void run(const std::stop_token& stop);
    void takeBatch();

    TrackerPose pose_;
    glm::dvec3 nominal_;
    double spacingM_;
    Clock& clock_;
    UniqueFd socket_;
    std::uint16_t port_ = 0;
    FrameQueue<EyeSample, 64> queue_;
    std::atomic<std::uint64_t> received_{0}, accepted_{0}, damaged_{0}, limited_{0};
    std::jthread thread_; // last: it uses all of the above
};

} // namespace autostereo::devices
