#pragma once

#include "devices/unique_fd.hpp"
#include "tests/device/usbip/device.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace autostereo::test::usbip {

/// Status of a transfer or a packet, as the kernel counts them.
enum class Status : std::int32_t {
    Good = 0,
    Stall = -32,    ///< EPIPE
    Protocol = -71, ///< EPROTO: lost on the way
    Lost = -18,     ///< EXDEV: a part of an isochronous transfer
    Overflow = -75, ///< EOVERFLOW: more than was asked for
};

/// One interval of an isochronous transfer.
struct IsoPacket {
    std::uint32_t offset = 0;
    std::uint32_t length = 0;
    std::uint32_t actual = 0;
    Status status = Status::Good;
};

/// The host wants a transfer.
struct Submit {
    std::uint32_t sequence = 0;
    std::uint8_t endpoint = 0; ///< with the direction's bit
    std::uint32_t length = 0;
    Setup setup;
    Bytes data;                     ///< OUT
    std::vector<IsoPacket> packets; ///< isochronous
};

/// The host no longer wants the transfer `victim`.
struct Unlink {
    std::uint32_t sequence = 0;
    std::uint32_t victim = 0;
};

using Request = std::variant<Submit, Unlink>;

/// Messages of USB/IP on a stream socket, device side; all fields are big endian there.
/// See the kernel's Documentation/usb/usbip_protocol.rst. Thread-bound.
class Wire {
  public:
    explicit Wire(devices::UniqueFd socket) : socket_(std::move(socket)) {}

    [[nodiscard]] int fd() const { return socket_.get(); }
    /// The next message, of which the first byte must have arrived. Nothing: the host is gone, or
    /// what it says makes no sense.
    [[nodiscard]] std::optional<Request> receive(const std::map<std::uint8_t, Endpoint>& endpoints);

    /// Ends a transfer. False: the host is gone.
    [[nodiscard]] bool reply(const Submit& submit, Status status,
                             std::span<const std::uint8_t> data);
    [[nodiscard]] bool unlinked(const Unlink& unlink, bool found);

  private:
    [[nodiscard]] bool get(void* bytes, std::size_t count);
    /// Header, data, table; in one go, as each goes through the kernel.
    [[nodiscard]] bool put(std::array<std::span<const std::uint8_t>, 3> parts);

    devices::UniqueFd socket_;
};

} // namespace autostereo::test::usbip
