#pragma once

#include "devices/kinect2/raw/raw_tap.hpp"
#include "devices/kinect2/unit_packets.hpp"
#include "devices/kinect2/usb/find_units.hpp"
#include "devices/kinect2/usb/unit_control.hpp"
#include "devices/kinect2/usb/usb_stream.hpp"
#include "devices/latest.hpp"
#include "devices/silence_watch.hpp"

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace autostereo::devices::kinect2 {

/// How long the streams of a camera may be silent, also of one that comes back.
struct UnitPatience {
    SilenceWatch depth;
    SilenceWatch color;
};

/// A running camera. A thread of its own takes packets off the bus and puts frames together, which
/// may be silent or lost as a whole: then the device is closed and the unit is of no more use.
/// Thread-safe but for its construction.
class Unit {
  public:
    struct Counters : UnitPackets::Counters {
        std::uint64_t depthUnderruns = 0; ///< see UsbStream::underruns
    };

    /// Opens and starts it, about a quarter of a second. Throws DeviceError.
    Unit(const UnitNode& node, std::shared_ptr<UnitPatience> patience,
         std::shared_ptr<RawTap> tap = nullptr);
    ~Unit();
    Unit(const Unit&) = delete;
    Unit& operator=(const Unit&) = delete;

    [[nodiscard]] const UnitFacts& facts() const { return facts_; }
    /// The newest one that nobody has yet; each for one reader. They end when it is lost.
    [[nodiscard]] Latest<TimedDepth>& depth() { return depth_; }
    [[nodiscard]] Latest<TimedColor>& color() { return color_; }
    [[nodiscard]] Counters counters() const;
    /// Gets all packets from now on.
    void setTap(std::shared_ptr<RawTap> tap);
    [[nodiscard]] bool lost() const { return lost_.load(std::memory_order_acquire); }
    [[nodiscard]] std::string whyLost() const;

  private:
    void startStreams();
    void run(const std::stop_token& stop);
    void watchSilence();
    void takeDepth(std::span<const std::byte> packet, bool intact);
    void takeColor(std::span<const std::byte> packet, bool intact);
    void publishCounters();
    void takeNewTap();
    void shutDown();

    std::string name_;
    std::shared_ptr<UnitPatience> patience_;
    std::unique_ptr<UsbLink> link_; ///< none: closed
    UnitFacts facts_;
    UnitPackets packets_;
    std::shared_ptr<RawTap> tap_; ///< of the thread
    TimedDepth nextDepth_;
    TimedColor nextColor_;
    std::vector<std::unique_ptr<UsbStream>> streams_;
    Latest<TimedDepth> depth_;
    Latest<TimedColor> color_;
    mutable std::mutex mutex_;
    Counters counters_;              ///< under mutex_
    std::string whyLost_;            ///< under mutex_
    std::shared_ptr<RawTap> newTap_; ///< under mutex_
    std::atomic<bool> lost_{false};
    std::jthread thread_; // last: it uses all of the above
};

} // namespace autostereo::devices::kinect2
