#include "devices/record/payloads.hpp"

#include "devices/replay/jpeg_mirror.hpp"

#include "devices/replay/kinect_recording.hpp"

#include <array>
#include <bit>
#include <cstdio>
#include <utility>

namespace autostereo::devices {

namespace {

struct Kept {
    const char* fourCc;
    int bits;
    const char* mode; ///< first half of the vendor's name of it
};

Kept keptAs(const FrameMetadata& picture) {
    if (picture.encodedBytes > 0) return {"MJPG", 24, "MJPG_"};
    if (picture.format == PixelFormat::Nv12) return {"NV12", 12, "NV12_"};
    if (picture.format == PixelFormat::Yuyv || picture.format == PixelFormat::Uyvy)
        return {"YUY2", 16, "YUY2_"};
    return {"BGRA", 32, "BGRA_"};
}

RecordingTrack track(const char* name, const FrameMetadata& first, const Kept& kept,
                     Duration period) {
    return {name, kept.fourCc, first.width, first.height, kept.bits, period, {}};
}

/// The vendor's name for a depth camera's mode; its own size for any other.
std::string depthMode(const FrameMetadata& first) {
    struct Mode {
        int width, height;
        const char* name;
    };
    constexpr std::array<Mode, 4> kModes{{{640, 576, "NFOV_UNBINNED"},
                                          {320, 288, "NFOV_2X2BINNED"},
                                          {1024, 1024, "WFOV_UNBINNED"},
                                          {512, 512, "WFOV_2X2BINNED"}}};
    for (const Mode& mode : kModes)
        if (mode.width == first.width && mode.height == first.height) return mode.name;
    return std::to_string(first.width) + "x" + std::to_string(first.height);
}

std::string roundTrip(double number) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.17g", number);
    return text.data();
}

/// Where blue, green and red stand in a pixel of so many bytes; grey has one for all.
struct Order {
    std::size_t bytes, blue, green, red;
};

Order orderOf(PixelFormat format) {
    switch (format) {
    case PixelFormat::Bgra8:
        return {4, 0, 1, 2};
    case PixelFormat::Rgb8:
        return {3, 2, 1, 0};
    case PixelFormat::Bgr8:
        return {3, 0, 1, 2};
    case PixelFormat::Grey8:
        return {1, 0, 0, 0};
    default:
        return {4, 2, 1, 0};
    }
}

std::vector<std::byte> blueGreenRed(std::span<const std::byte> pixels, const Order& order) {
    std::vector<std::byte> payload(pixels.size() / order.bytes * 4, std::byte{255});
    for (std::size_t from = 0, to = 0; to < payload.size(); from += order.bytes, to += 4) {
        payload[to] = pixels[from + order.blue];
        payload[to + 1] = pixels[from + order.green];
        payload[to + 2] = pixels[from + order.red];
    }
    return payload;
}

/// Each two bytes the other way round.
std::vector<std::byte> swapped(std::vector<std::byte> bytes) {
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
        std::swap(bytes[i], bytes[i + 1]);
    return bytes;
}

} // namespace

RecordingTrack colorTrack(const FrameMetadata& first, Duration period) {
    const Kept kept = keptAs(first);
    RecordingTrack color = track("COLOR", first, kept, period);
    color.tags = {{"K4A_COLOR_MODE", kept.mode + std::to_string(first.height) + "P"}};
    return color;
}

RecordingTrack depthTrack(const FrameMetadata& first, Duration period) {
    RecordingTrack depth = track("DEPTH", first, {"b16g", 16, ""}, period);
    depth.tags = {{"K4A_DEPTH_MODE", depthMode(first)}};
    // The convention's counts are millimetres; whoever does not know this tag sees others.
    if (first.depthUnitM != 0.001)
        depth.tags.emplace_back(kDepthUnitTag, roundTrip(first.depthUnitM));
    return depth;
}

RecordingTrack infraredTrack(const FrameMetadata& first, Duration period) {
    RecordingTrack infrared = track("IR", first, {"b16g", 16, ""}, period);
    infrared.tags = {{"K4A_IR_MODE", "ACTIVE"}};
    return infrared;
}

std::span<const std::byte> sentBytes(const Frame& frame) {
    return frame.metadata().encodedBytes > 0 ? frame.encoded() : frame.pixels();
}

std::vector<std::byte> colorPayload(const FrameMetadata& form, std::vector<std::byte> bytes) {
    if (form.encodedBytes > 0) return form.encodedMirrored ? mirroredJpeg(bytes) : bytes;
    switch (form.format) {
    case PixelFormat::Nv12:
    case PixelFormat::Yuyv:
    case PixelFormat::Bgra8:
        return bytes;
    case PixelFormat::Uyvy:
        return swapped(std::move(bytes));
    default:
        return blueGreenRed(bytes, orderOf(form.format));
    }
}

std::vector<std::byte> countsPayload(std::vector<std::byte> bytes) {
    static_assert(std::endian::native == std::endian::little);
    return swapped(std::move(bytes));
}

} // namespace autostereo::devices
