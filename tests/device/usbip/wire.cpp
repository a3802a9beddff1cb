#include "tests/device/usbip/wire.hpp"

#include <algorithm>
#include <cerrno>

#include <sys/socket.h>
#include <sys/uio.h>

namespace autostereo::test::usbip {

namespace {

constexpr std::uint32_t kSubmit = 1, kUnlink = 2, kSubmitted = 3, kUnlinked = 4; // commands

constexpr std::size_t kHeaderBytes = 48, kPacketBytes = 16, kSetupAt = 40;
constexpr std::uint32_t kMostPackets = 1024, kMostBytes = 64U << 20U;

void putBig(Bytes& bytes, std::uint32_t value) {
    for (const unsigned shift : {24U, 16U, 8U, 0U})
        put8(bytes, value >> shift);
}

std::uint32_t bigAt(const Bytes& bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8U | bytes[at + i];
    return value;
}

std::uint16_t little16At(const Bytes& bytes, std::size_t at) {
    return static_cast<std::uint16_t>(bytes[at] | bytes[at + 1] << 8U);
}

/// Command and sequence number, then fields that replies leave zero.
Bytes replyHeader(std::uint32_t command, std::uint32_t sequence, Status status) {
    Bytes bytes;
    for (const std::uint32_t field :
         {command, sequence, 0U, 0U, 0U, static_cast<std::uint32_t>(status)})
        putBig(bytes, field);
    return bytes;
}

Setup setupOf(const Bytes& header) {
    return {header[kSetupAt], header[kSetupAt + 1], little16At(header, kSetupAt + 2),
            little16At(header, kSetupAt + 4), little16At(header, kSetupAt + 6)};
}

} // namespace

bool Wire::get(void* bytes, std::size_t count) {
    auto* to = static_cast<std::uint8_t*>(bytes);
    while (count > 0) {
        const ssize_t got = recv(socket_.get(), to, count, 0);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        to += got;
        count -= static_cast<std::size_t>(got);
    }
    return true;
}

bool Wire::put(std::array<std::span<const std::uint8_t>, 3> parts) {
    std::size_t left = parts[0].size() + parts[1].size() + parts[2].size();
    while (left > 0) {
        std::array<iovec, 3> list{};
        for (std::size_t i = 0; i < parts.size(); ++i) // the kernel only reads
            list[i] = {const_cast<std::uint8_t*>(parts[i].data()), parts[i].size()};
        msghdr message{};
        message.msg_iov = list.data();
        message.msg_iovlen = list.size();
        const ssize_t sent = sendmsg(socket_.get(), &message, MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent <= 0) return false;
        left -= static_cast<std::size_t>(sent);
        auto passed = static_cast<std::size_t>(sent);
        for (auto& part : parts) {
            const std::size_t count = std::min(passed, part.size());
            part = part.subspan(count);
            passed -= count;
        }
    }
    return true;
}

std::optional<Request> Wire::receive(const std::map<std::uint8_t, Endpoint>& endpoints) {
    Bytes header(kHeaderBytes);
    if (!get(header.data(), header.size())) return std::nullopt;
    const std::uint32_t command = bigAt(header, 0), sequence = bigAt(header, 4);
    if (command == kUnlink) return Unlink{sequence, bigAt(header, 20)};
    if (command != kSubmit) return std::nullopt;

    const bool in = bigAt(header, 12) != 0;
    Submit submit{sequence,
                  static_cast<std::uint8_t>((bigAt(header, 16) & 0xfU) | (in ? 0x80U : 0)),
                  bigAt(header, 24),
                  setupOf(header),
                  {},
                  {}};
    const auto endpoint = endpoints.find(submit.endpoint);
    const bool isochronous =
        endpoint != endpoints.end() && endpoint->second.type == EndpointType::Isochronous;
    const std::uint32_t packets = isochronous ? bigAt(header, 32) : 0;
    if (submit.length > kMostBytes || packets > kMostPackets) return std::nullopt;
    if (!in) {
        submit.data.resize(submit.length);
        if (!get(submit.data.data(), submit.data.size())) return std::nullopt;
    }
    Bytes table(packets * kPacketBytes);
    if (!get(table.data(), table.size())) return std::nullopt;
    for (std::size_t at = 0; at < table.size(); at += kPacketBytes)
        submit.packets.push_back({bigAt(table, at), bigAt(table, at + 4), 0, Status::Good});
    return submit;
}

bool Wire::reply(const Submit& submit, Status status, std::span<const std::uint8_t> data) {
    const bool in = (submit.endpoint & 0x80U) != 0 || submit.setup.toHost();
    Bytes bytes = replyHeader(kSubmitted, submit.sequence, status);
    std::uint32_t lost = 0;
    for (const IsoPacket& packet : submit.packets)
        lost += packet.status == Status::Good ? 0 : 1;
    const auto taken = static_cast<std::uint32_t>(in ? data.size() : submit.data.size());
    for (const std::uint32_t field :
         {taken, 0U, static_cast<std::uint32_t>(submit.packets.size()), lost, 0U, 0U})
        putBig(bytes, field);
    Bytes table;
    for (const IsoPacket& packet : submit.packets)
        for (const std::uint32_t field : {packet.offset, packet.length, packet.actual,
                                          static_cast<std::uint32_t>(packet.status)})
            putBig(table, field);
    if (!in) data = {}; // replies carry a count alone
    return put({bytes, data, table});
}

bool Wire::unlinked(const Unlink& unlink, bool found) {
    constexpr auto kReset = static_cast<Status>(-104); // ECONNRESET: it had not ended yet
    Bytes bytes = replyHeader(kUnlinked, unlink.sequence, found ? kReset : Status::Good);
    bytes.resize(kHeaderBytes);
    return put({bytes});
}

} // namespace autostereo::test::usbip
