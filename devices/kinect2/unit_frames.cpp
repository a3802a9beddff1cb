#include "devices/kinect2/unit_frames.hpp"

#include "devices/kinect2/mirror.hpp"
#include "devices/kinect2/registration.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace autostereo::devices::kinect2 {

namespace {

/// Millimetres to counts; 0 and what does not fit: none.
std::uint16_t counts(float millimetres) {
    constexpr auto kPerMillimetre = static_cast<float>(0.001 / kDepthUnitM);
    constexpr float kMost = 65534;
    const float value = std::nearbyint(millimetres * kPerMillimetre);
    return value >= 1 && value <= kMost ? static_cast<std::uint16_t>(value) : std::uint16_t{0};
}

} // namespace

DepthFrames::DepthFrames(std::shared_ptr<UnitContinuity> continuity, const UnitFacts& facts)
    : continuity_(std::move(continuity)), sequence_(continuity_->nextDepth) {
    if (!continuity_->decoder)
        continuity_->decoder = std::make_shared<const PhaseDecoder>(facts.phases, facts.depth);
}

std::optional<Frame> DepthFrames::convert(const TimedDepth& raw) {
    FrameMetadata metadata;
    metadata.format = PixelFormat::Depth16;
    metadata.width = kWidth;
    metadata.height = kHeight;
    metadata.depthUnitM = kDepthUnitM;
    metadata.hasAmplitude = true;
    metadata.capturedAt = raw.capturedAt;
    metadata.sequence = sequence_.map(raw.frame.sequence);
    continuity_->nextDepth = metadata.sequence + 1;
    auto frame = pool_.acquire(metadata);
    if (!frame) {
        ++counters_.starved;
        return std::nullopt;
    }
    continuity_->decoder->decode(raw.frame, picture_);
    constexpr auto kColumns = static_cast<std::size_t>(kWidth);
    for (std::size_t row = 0; row < kPixels; row += kColumns) {
        const auto depth = std::span(picture_.depthMm).subspan(row, kColumns);
        const auto infrared = std::span(picture_.infrared).subspan(row, kColumns);
        std::transform(depth.rbegin(), depth.rend(), frame->depth().subspan(row).begin(), counts);
        std::ranges::reverse_copy(infrared, frame->amplitude().subspan(row).begin());
    }
    ++counters_.delivered;
    return frame;
}

ColorFrames::ColorFrames(std::shared_ptr<UnitContinuity> continuity)
    : continuity_(std::move(continuity)), sequence_(continuity_->nextColor) {}

std::optional<Frame> ColorFrames::convert(const TimedColor& raw) try {
    FrameMetadata metadata;
    metadata.format = PixelFormat::Rgba8;
    metadata.width = kColorWidth;
    metadata.height = kColorHeight;
    metadata.capturedAt = raw.capturedAt;
    metadata.sequence = sequence_.map(raw.sequence);
    metadata.encodedBytes = raw.jpeg.size();
    metadata.encodedMirrored = true;
    continuity_->nextColor = metadata.sequence + 1;
    if (jpeg_.open(raw.jpeg).size() != PictureSize{kColorWidth, kColorHeight}) {
        ++counters_.damaged;
        return std::nullopt;
    }
    auto frame = pool_.acquire(metadata);
    if (!frame) {
        ++counters_.starved;
        return std::nullopt;
    }
    jpeg_.decode(frame->pixels());
    // Slots are aligned for any type.
    auto* pixels = reinterpret_cast<std::uint32_t*>(frame->pixels().data());
    mirrorRows({pixels, frame->pixelCount()}, kColorWidth);
    std::ranges::copy(raw.jpeg, frame->encoded().begin());
    ++counters_.delivered;
    return frame;
} catch (const std::exception&) {
    ++counters_.damaged;
    return std::nullopt;
}

} // namespace autostereo::devices::kinect2
