#pragma once

#include "tests/device/usbip/device.hpp"
#include "tests/support/kinect2_unit.hpp"

#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

namespace autostereo::test {

/// What an emulated Kinect v2 is and shows.
struct Kinect2Show {
    Kinect2Unit unit;
    std::string serial = "000001234567";
    double fps = 30;
    std::vector<devices::kinect2::RawDepthFrame> exposures; ///< shown in turn
    std::vector<usbip::Bytes> jpegs;                        ///< likewise
};

/// A Kinect v2 as a program: commands and pages on bulk endpoints, raw phases isochronous in step
/// with the clock (an interval that the host lets pass is lost, as on a real bus), colour as JPEG.
/// Its descriptors are made from what is known of real ones, without the microphones. `powerUp`,
/// counters and switches may be used from any thread.
class Kinect2Camera final : public usbip::Device {
  public:
    static constexpr std::uint8_t kCommands = 0x02, kReplies = 0x81, kColor = 0x83, kDepth = 0x84;

    explicit Kinect2Camera(Kinect2Show show);

    /// As after the plug was pulled: forgets everything but its counters.
    void powerUp();
    /// Commands that are answered with "not ready" from now on.
    void sleepFor(int statusRequests) { sleep_.store(statusRequests); }
    /// After an underrun in a sub-image: go on where the first one of a frame lacks what came, so
    /// that a reader who joins both has one of the right length.
    void setTreacherous(bool on) { treacherous_.store(on); }
    /// Damages what it says: gets every reply, data and completion alike.
    void setReplyFault(std::function<void(usbip::Bytes&)> fault);

    [[nodiscard]] unsigned depthFramesSent() const { return depthFrames_.load(); }
    /// Of these, in which the host let intervals pass.
    [[nodiscard]] unsigned depthFramesCut() const { return depthCut_.load(); }
    /// How often the host was too late with transfers for the phases.
    [[nodiscard]] unsigned underruns() const { return underruns_.load(); }
    [[nodiscard]] unsigned colorFramesSent() const { return colorFrames_.load(); }
    [[nodiscard]] bool streaming() const { return streaming_.load(); }
    [[nodiscard]] const Kinect2Show& show() const { return show_; }

    [[nodiscard]] usbip::Descriptors descriptors() const override;
    [[nodiscard]] std::optional<usbip::Bytes> control(const usbip::Setup& setup,
                                                      std::span<const std::uint8_t> data) override;
    [[nodiscard]] usbip::Answer read(std::uint8_t endpoint, std::size_t capacity,
                                     usbip::Time now) override;
    [[nodiscard]] usbip::Answer write(std::uint8_t endpoint, std::span<const std::uint8_t> data,
                                      usbip::Time now) override;
    [[nodiscard]] usbip::Bytes readInterval(std::uint8_t endpoint, std::size_t capacity,
                                            usbip::Time interval) override;
    [[nodiscard]] usbip::Time resumeAt(std::uint8_t endpoint, usbip::Time ended,
                                       usbip::Time now) override;

  private:
    using Packets = std::vector<usbip::Bytes>;

    /// A bulk reply or picture of which a part may have been sent.
    struct Outgoing {
        usbip::Bytes bytes;
        std::size_t sent = 0;
        [[nodiscard]] usbip::Bytes next(std::size_t capacity);
        [[nodiscard]] bool done() const { return sent == bytes.size(); }
    };
    void answer(std::uint32_t id, std::uint32_t command, std::uint32_t parameter,
                std::uint32_t replyBytes);
    [[nodiscard]] usbip::Bytes replyTo(std::uint32_t command, std::uint32_t parameter);
    [[nodiscard]] usbip::Bytes serialPage() const;
    void setStreaming(bool on);
    void noteSlot(std::int64_t number, std::size_t slot, std::size_t slots);
    [[nodiscard]] usbip::Answer readColor(std::size_t capacity, usbip::Time now);
    /// Device clock, 0.125 ms.
    [[nodiscard]] std::uint32_t stampOf(usbip::Time time) const;
    [[nodiscard]] std::chrono::nanoseconds period() const;

    Kinect2Show show_;
    std::vector<Packets> depth_; ///< of each exposure
    std::mutex mutex_;
    std::function<void(usbip::Bytes&)> replyFault_; ///< under mutex_
    bool reset_ = false;                            ///< under mutex_
    std::deque<Outgoing> replies_;
    Outgoing picture_;
    usbip::Time poweredAt_{};
    usbip::Time since_{}; ///< when the first frames of both streams were taken
    std::int64_t colorNumber_ = 0;
    std::int64_t depthNumber_ = -1;
    std::size_t depthSlot_ = 0; ///< of the frame, the next one
    bool depthIsCut_ = false;
    std::atomic<bool> streaming_{false}, treacherous_{false};
    std::atomic<int> sleep_{0};
    std::atomic<unsigned> depthFrames_{0}, depthCut_{0}, colorFrames_{0}, underruns_{0};
};

} // namespace autostereo::test
