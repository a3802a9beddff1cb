#include "tests/device/usbip/pipe.hpp"

#include <algorithm>
#include <utility>

namespace autostereo::test::usbip {

namespace {

/// A guest that was busy for longer loses intervals, as a real bus would.
constexpr auto kMostLate = std::chrono::milliseconds(50);

} // namespace

std::chrono::microseconds Pipe::interval() const {
    constexpr unsigned kMicroframeUs = 125, kMostExponent = 16;
    const unsigned exponent = std::clamp<unsigned>(endpoint_.interval, 1, kMostExponent) - 1;
    return std::chrono::microseconds(kMicroframeUs << exponent);
}

void Pipe::push(Submit submit) {
    const Time now = std::chrono::steady_clock::now();
    if (isochronous() && waiting_.empty() && interval_ < now)
        interval_ = std::max(now, device_.resumeAt(endpoint_.address, interval_, now));
    waiting_.push_back(std::move(submit));
}

bool Pipe::remove(std::uint32_t sequence) {
    return std::erase_if(waiting_, [&](const Submit& one) { return one.sequence == sequence; }) > 0;
}

std::optional<Time> Pipe::due() const {
    if (waiting_.empty() || faults_.silent) return std::nullopt;
    if (!isochronous()) return askAgain_;
    return interval_ + interval() * static_cast<int>(waiting_.front().packets.size());
}

bool Pipe::serve(Wire& wire, Time now) {
    while (due().value_or(Time::max()) <= now)
        if (!(isochronous() ? serveIsochronous(wire) : serveOne(wire, now))) return false;
    return true;
}

bool Pipe::happens(double share) {
    return share > 0 && std::uniform_real_distribution<>(0, 1)(random_) < share;
}

bool Pipe::countsDown() {
    if (!faults_.unplugAfter) return true;
    if (*faults_.unplugAfter == 0) return false;
    --*faults_.unplugAfter;
    return true;
}

std::optional<Pipe::Packet> Pipe::throughFaults(const Ask& ask) {
    std::optional<Packet> packet;
    if (!held_.empty()) {
        packet = std::move(held_.front());
        held_.pop_front();
        return packet;
    }
    packet = ask();
    if (!packet || packet->data.empty()) return packet;
    if (happens(faults_.reorder))
        if (auto next = ask()) held_.push_back(std::exchange(*packet, std::move(*next)));
    if (happens(faults_.duplicate)) held_.push_back(*packet);
    if (happens(faults_.truncate)) packet->data.resize(packet->data.size() / 2);
    if (happens(faults_.lose)) packet = Packet{{}, isochronous() ? Status::Lost : Status::Protocol};
    return packet;
}

std::optional<Pipe::Packet> Pipe::ask(const Submit& submit, Time now) {
    const bool in = (submit.endpoint & 0x80U) != 0;
    Answer answer = in ? device_.read(submit.endpoint, submit.length, now)
                       : device_.write(submit.endpoint, submit.data, now);
    if (answer.kind == Answer::Kind::Later) {
        askAgain_ = std::max(answer.askAgain, now + std::chrono::microseconds(1));
        return std::nullopt;
    }
    if (answer.kind == Answer::Kind::Stall) return Packet{{}, Status::Stall};
    answer.data.resize(std::min<std::size_t>(answer.data.size(), submit.length));
    return Packet{std::move(answer.data), Status::Good};
}

bool Pipe::serveOne(Wire& wire, Time now) {
    const Submit& submit = waiting_.front();
    const std::optional<Packet> packet =
        faults_.stall ? Packet{{}, Status::Stall} : throughFaults([&] { return ask(submit, now); });
    if (!packet) return true;
    if (!countsDown()) return false;
    const Status status = faults_.babble ? Status::Overflow : packet->status;
    const bool replied = wire.reply(submit, status, packet->data);
    waiting_.pop_front();
    return replied;
}

bool Pipe::serveIsochronous(Wire& wire) {
    Submit submit = std::move(waiting_.front());
    waiting_.pop_front();
    // A host controller says which packet comes after intervals that it missed.
    const Time earliest = std::chrono::steady_clock::now() - kMostLate;
    bool missed = interval_ < earliest;
    interval_ = std::max(interval_, earliest);
    Bytes data;
    data.reserve(submit.length);
    for (IsoPacket& packet : submit.packets) {
        const auto next = throughFaults([&] {
            return Packet{device_.readInterval(endpoint_.address, packet.length, interval_),
                          Status::Good};
        });
        interval_ += interval();
        if (!next) continue;
        if (!next->data.empty() && !countsDown()) return false;
        const std::size_t length = std::min<std::size_t>(next->data.size(), packet.length);
        data.insert(data.end(), next->data.begin(),
                    next->data.begin() + static_cast<std::ptrdiff_t>(length));
        packet.actual = static_cast<std::uint32_t>(length);
        packet.status = faults_.babble ? Status::Overflow : next->status;
        if (std::exchange(missed, false)) packet.status = Status::Lost;
    }
    return wire.reply(submit, faults_.stall ? Status::Stall : Status::Good, data);
}

} // namespace autostereo::test::usbip
