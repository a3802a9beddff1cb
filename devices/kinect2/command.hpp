#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace autostereo::devices::kinect2 {

/// Commands on bulk endpoint 0x02; replies come on 0x81.
enum class Command : std::uint32_t {
    ReadVersions = 0x02,
    InitStreams = 0x09,
    StopStreams = 0x0a,
    ReadHardwareInfo = 0x14,
    ReadStatus = 0x16,
    ReadPage = 0x22,
    EnableStream = 0x2b,
    SetMode = 0x4b,
};

/// Parameter of ReadPage.
enum class Page : std::uint32_t { Serial = 1, PhaseOffsets = 2, DepthCamera = 3, ColorCamera = 4 };

/// Parameter of ReadStatus whose lowest bit says that streams may be started.
inline constexpr std::uint32_t kReadyStatus = 0x090000;

/// The most bytes that a reply to each may have.
inline constexpr std::uint32_t kVersionsBytes = 0x200;
inline constexpr std::uint32_t kHardwareInfoBytes = 0x5c;
inline constexpr std::uint32_t kStatusBytes = 4;
inline constexpr std::uint32_t kSerialBytes = 0x80;
inline constexpr std::uint32_t kPageBytes = 0x1c0000;

/// A request for `replyBytes` at most, with up to four parameters. `id` comes back in its
/// completion.
[[nodiscard]] std::vector<std::byte> encodeCommand(std::uint32_t id, Command command,
                                                   std::uint32_t replyBytes,
                                                   std::initializer_list<std::uint32_t> parameters);

inline constexpr std::size_t kCompletionBytes = 16;

/// What is wrong with the 16 bytes that end a reply, as a phrase ("status 5 instead of 0"), or
/// nothing. Takes any bytes.
[[nodiscard]] std::optional<std::string> problemWithCompletion(std::span<const std::byte> bytes,
                                                               std::uint32_t id);

/// Version of the firmware's application part, "4.0.3911"; "unknown" where the reply is too short.
[[nodiscard]] std::string firmwareVersion(std::span<const std::byte> reply);

/// The serial number's letters and digits; empty where the page holds none.
[[nodiscard]] std::string serialNumber(std::span<const std::byte> page);

/// Reply to ReadStatus of kReadyStatus.
[[nodiscard]] bool isReady(std::span<const std::byte> reply);

} // namespace autostereo::devices::kinect2
