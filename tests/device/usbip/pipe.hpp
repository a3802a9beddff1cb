#pragma once

#include "tests/device/usbip/faults.hpp"
#include "tests/device/usbip/wire.hpp"

#include <deque>
#include <functional>
#include <optional>
#include <random>

namespace autostereo::test::usbip {

/// One endpoint's transfers that the host waits for, answered from the device as they fall due,
/// through the faults of the wire. Thread-bound.
class Pipe {
  public:
    Pipe(Device& device, const Endpoint& endpoint) : device_(device), endpoint_(endpoint) {}

    void setFaults(const Faults& faults) { faults_ = faults; }
    void push(Submit submit);
    /// Forgets a transfer; false where it is not there any more.
    [[nodiscard]] bool remove(std::uint32_t sequence);
    /// The host asked for something else: what had nothing may have something now.
    void poke() { askAgain_ = {}; }

    /// Answers what is due. False: the device is gone from the bus, or the host is.
    [[nodiscard]] bool serve(Wire& wire, Time now);
    /// When `serve` has something to do next; nothing: not before another request.
    [[nodiscard]] std::optional<Time> due() const;

  private:
    struct Packet {
        Bytes data;
        Status status = Status::Good;
    };
    /// What the device has next; nothing: not yet.
    using Ask = std::function<std::optional<Packet>()>;

    [[nodiscard]] bool serveOne(Wire& wire, Time now);
    [[nodiscard]] bool serveIsochronous(Wire& wire);
    [[nodiscard]] std::optional<Packet> ask(const Submit& submit, Time now);
    [[nodiscard]] std::optional<Packet> throughFaults(const Ask& ask);
    [[nodiscard]] bool happens(double share);
    [[nodiscard]] bool countsDown();
    [[nodiscard]] bool isochronous() const { return endpoint_.type == EndpointType::Isochronous; }
    [[nodiscard]] std::chrono::microseconds interval() const;

    Device& device_;
    Endpoint endpoint_;
    Faults faults_;
    std::deque<Submit> waiting_;
    Time askAgain_{};
    Time interval_{}; ///< isochronous: when the next one starts
    std::deque<Packet> held_;
    std::mt19937 random_{20}; // the same faults in every run
};

} // namespace autostereo::test::usbip
