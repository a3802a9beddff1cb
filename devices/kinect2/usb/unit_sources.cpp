#include "devices/kinect2/usb/unit_sources.hpp"

#include "devices/kinect2/mirror.hpp"
#include "devices/kinect2/registration.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <utility>

namespace autostereo::devices::kinect2 {

namespace {

TimePoint now() { return std::chrono::steady_clock::now(); }

/// What either source does until `deadline`; `convert` makes a frame of what was taken, or counts.
template<class T, class Convert>
ReadResult readFrom(Unit& unit, Latest<T>& latest, T& raw, TimePoint deadline,
                    const Convert& convert) try {
    do {
        if (latest.take(raw, deadline)) {
            if (auto frame = convert()) return std::move(*frame);
        } else if (unit.lost()) {
            return Disconnected{unit.whyLost()};
        }
    } while (now() < deadline);
    return Timeout{};
} catch (const std::exception& error) {
    return Disconnected{std::string("kinect2: ") + error.what()};
}

/// Millimetres to counts; 0 and what does not fit: none.
std::uint16_t counts(float millimetres) {
    constexpr auto kPerMillimetre = static_cast<float>(0.001 / kDepthUnitM);
    constexpr float kMost = 65534;
    const float value = std::nearbyint(millimetres * kPerMillimetre);
    return value >= 1 && value <= kMost ? static_cast<std::uint16_t>(value) : std::uint16_t{0};
}

} // namespace

DepthSource::DepthSource(std::shared_ptr<Unit> unit, std::shared_ptr<UnitContinuity> continuity)
    : unit_(std::move(unit)), continuity_(std::move(continuity)),
      sequence_(continuity_->nextDepth) {
    if (!continuity_->decoder)
        continuity_->decoder =
            std::make_shared<const PhaseDecoder>(unit_->facts().phases, unit_->facts().depth);
}

ReadResult DepthSource::read(TimePoint deadline) noexcept {
    return readFrom(*unit_, unit_->depth(), raw_, deadline, [this] { return convert(); });
}

std::optional<Frame> DepthSource::convert() {
    FrameMetadata metadata;
    metadata.format = PixelFormat::Depth16;
    metadata.width = kWidth;
    metadata.height = kHeight;
    metadata.depthUnitM = kDepthUnitM;
    metadata.hasAmplitude = true;
    metadata.capturedAt = raw_.capturedAt;
    metadata.sequence = sequence_.map(raw_.frame.sequence);
    continuity_->nextDepth = metadata.sequence + 1;
    auto frame = pool_.acquire(metadata);
    if (!frame) {
        ++counters_.starved;
        return std::nullopt;
    }
    continuity_->decoder->decode(raw_.frame, picture_);
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

SourceCounters DepthSource::counters() const noexcept {
    SourceCounters all = counters_;
    all.damaged += unit_->counters().depth.brokenFrames;
    all.starved += unit_->depth().overwritten();
    return all;
}

ColorSource::ColorSource(std::shared_ptr<Unit> unit, std::shared_ptr<UnitContinuity> continuity)
    : unit_(std::move(unit)), continuity_(std::move(continuity)),
      sequence_(continuity_->nextColor) {}

ReadResult ColorSource::read(TimePoint deadline) noexcept {
    return readFrom(*unit_, unit_->color(), raw_, deadline, [this] { return convert(); });
}

std::optional<Frame> ColorSource::convert() try {
    FrameMetadata metadata;
    metadata.format = PixelFormat::Rgba8;
    metadata.width = kColorWidth;
    metadata.height = kColorHeight;
    metadata.capturedAt = raw_.capturedAt;
    metadata.sequence = sequence_.map(raw_.sequence);
    metadata.encodedBytes = raw_.jpeg.size();
    metadata.encodedMirrored = true;
    continuity_->nextColor = metadata.sequence + 1;
    if (jpeg_.open(raw_.jpeg).size() != PictureSize{kColorWidth, kColorHeight}) {
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
    std::ranges::copy(raw_.jpeg, frame->encoded().begin());
    ++counters_.delivered;
    return frame;
} catch (const std::exception&) {
    ++counters_.damaged;
    return std::nullopt;
}

SourceCounters ColorSource::counters() const noexcept {
    SourceCounters all = counters_;
    all.damaged += unit_->counters().color.broken;
    all.starved += unit_->color().overwritten();
    return all;
}

} // namespace autostereo::devices::kinect2
