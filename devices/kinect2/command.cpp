#include "devices/kinect2/command.hpp"

#include "devices/kinect2/little_endian.hpp"

#include <algorithm>
#include <cassert>

namespace autostereo::devices::kinect2 {

namespace {

constexpr std::uint32_t kRequestMagic = 0x06022009;
constexpr std::uint32_t kCompletionMagic = 0x0a6fe000;
constexpr std::size_t kMostParameters = 4;

} // namespace

std::vector<std::byte> encodeCommand(std::uint32_t id, Command command, std::uint32_t replyBytes,
                                     std::initializer_list<std::uint32_t> parameters) {
    assert(parameters.size() <= kMostParameters);
    std::vector<std::uint32_t> words{kRequestMagic, id, replyBytes,
                                     static_cast<std::uint32_t>(command), 0};
    words.insert(words.end(), parameters);
    const auto bytes = std::as_bytes(std::span(words));
    return {bytes.begin(), bytes.end()};
}

std::optional<std::string> problemWithCompletion(std::span<const std::byte> bytes,
                                                 std::uint32_t id) {
    if (bytes.size() != kCompletionBytes)
        return "a completion of " + std::to_string(bytes.size()) + " bytes instead of 16";
    FieldReader fields(bytes);
    if (fields.next<std::uint32_t>() != kCompletionMagic) return "no completion after its data";
    const auto answered = fields.next<std::uint32_t>();
    if (answered != id)
        return "the completion of command " + std::to_string(answered) + " instead of " +
               std::to_string(id);
    const auto status = fields.next<std::uint32_t>();
    if (status != 0) return "status " + std::to_string(status) + " instead of 0";
    return std::nullopt;
}

std::string firmwareVersion(std::span<const std::byte> reply) {
    struct Entry {
        std::uint16_t minor, major;
        std::uint32_t build, quickFix, unused;
    };
    constexpr std::size_t kApplication = 3;
    if (reply.size() < (kApplication + 1) * sizeof(Entry)) return "unknown";
    const auto entry = valueAt<Entry>(reply, kApplication * sizeof(Entry));
    return std::to_string(entry.major) + "." + std::to_string(entry.minor) + "." +
           std::to_string(entry.build);
}

std::string serialNumber(std::span<const std::byte> page) {
    std::string serial;
    for (std::size_t i = 0; i < std::min<std::size_t>(page.size(), kSerialBytes); i += 2) {
        const auto letter = std::to_integer<char>(page[i]);
        const bool plain = (letter >= '0' && letter <= '9') || (letter >= 'A' && letter <= 'Z') ||
                           (letter >= 'a' && letter <= 'z');
        if (!plain) break;
        serial += letter;
    }
    return serial;
}

bool isReady(std::span<const std::byte> reply) {
    return reply.size() >= kStatusBytes && (valueAt<std::uint32_t>(reply, 0) & 1U) != 0;
}

} // namespace autostereo::devices::kinect2
