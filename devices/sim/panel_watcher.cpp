#include "devices/sim/panel_watcher.hpp"

#include "devices/input.hpp"
#include "devices/sim/hash.hpp"
#include "devices/uri.hpp"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace autostereo::devices::sim {

namespace {

constexpr std::array<std::array<double, 2>, 9> kTaps{{{-1.3, -1.3},
                                                      {0, -1.5},
                                                      {1.3, -1.3},
                                                      {-1.5, 0},
                                                      {0, 0},
                                                      {1.5, 0},
                                                      {-1.3, 1.3},
                                                      {0, 1.5},
                                                      {1.3, 1.3}}};
/// Where the panel's corners lie in the picture: upper left, upper right, lower right, lower left.
constexpr std::array<std::array<double, 2>, 4> kCorners{
    {{31, 24}, {294, 41}, {281, 207}, {22, 196}}};
constexpr float kRoom = 20, kWhite = 190; // levels
constexpr float kSigma = 2;

/// Unit square -> quadrilateral (Heckbert 1989, section 2.2.3); columns of the matrix multiply x,
/// y, 1.
glm::dmat3 toQuadrilateral(const std::array<std::array<double, 2>, 4>& p) {
    const auto at = [&](std::size_t i) { return glm::dvec2(p.at(i)[0], p.at(i)[1]); };
    const glm::dvec2 d1 = at(1) - at(2), d2 = at(3) - at(2), s = at(0) - at(1) + at(2) - at(3);
    const double area = d1.x * d2.y - d2.x * d1.y;
    const double g = (s.x * d2.y - d2.x * s.y) / area, h = (d1.x * s.y - s.x * d1.y) / area;
    return {glm::dvec3(at(1) - at(0) + g * at(1), g), glm::dvec3(at(3) - at(0) + h * at(3), h),
            glm::dvec3(at(0), 1)};
}

Duration fromMs(double ms) { return Duration(std::llround(1e6 * ms)); }

} // namespace

WatchedPanel watchedPanel(const std::string& address) {
    const Uri uri = parseUri(address == "sim" ? "sim:panel" : address);
    if (uri.scheme != "sim" || uri.path != "panel")
        throw AddressError(address +
                           ": no camera that sees the panel (allowed sim, sim:panel?...)");
    uri.allowOnly({"delay_ms", "exposure_ms", "transfer_ms", "fps", "seed"});
    return {fromMs(uri.number("delay_ms", 20, 0, 500)),
            fromMs(uri.number("exposure_ms", 8, 0.1, 50)),
            fromMs(uri.number("transfer_ms", 10, 0, 500)), uri.number("fps", 30, 1, 240),
            static_cast<std::uint64_t>(uri.number("seed", 1, 0, 1e9))};
}

PanelWatcher::PanelWatcher(const WatchedPanel& panel, Clock& clock)
    : panel_(panel), clock_(clock), startedAt_(clock.now()) {
    const glm::dmat3 panelFromPicture = glm::inverse(toQuadrilateral(kCorners));
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x)
            for (const auto& tap : kTaps) {
                const glm::dvec3 place = panelFromPicture * glm::dvec3(x + tap[0], y + tap[1], 1);
                places_.emplace_back(glm::dvec2(place) / place.z);
            }
}

PanelWatcher::Levels PanelWatcher::seenOf(const calib::Picture& panel) const {
    Levels levels(std::size_t{kWidth} * kHeight, kRoom);
    const glm::vec2 size(panel.width, panel.height);
    for (std::size_t pixel = 0; pixel < levels.size(); ++pixel)
        for (std::size_t tap = 0; tap < kTaps.size(); ++tap) {
            const glm::vec2 at = places_[pixel * kTaps.size() + tap] * size;
            if (!(at.x >= 0 && at.y >= 0 && at.x < size.x && at.y < size.y)) continue;
            const std::uint8_t level =
                panel.pixels[panel.offset(static_cast<int>(at.x), static_cast<int>(at.y))];
            levels[pixel] += kWhite / 255 / static_cast<float>(kTaps.size()) * level;
        }
    return levels;
}

TimePoint PanelWatcher::shown(const calib::Picture& panel) {
    Levels levels = seenOf(panel);
    // Under the lock, so that no exposure misses a swap that was before it.
    const std::scoped_lock lock(mutex_);
    const TimePoint now = clock_.now();
    seen_.push_back({now + panel_.delay, std::move(levels)});
    return now;
}

PanelWatcher::Levels PanelWatcher::exposed(TimePoint begin, TimePoint end) {
    const std::scoped_lock lock(mutex_);
    while (seen_.size() > 1 && seen_[1].from <= begin)
        seen_.pop_front();
    Levels sum(std::size_t{kWidth} * kHeight, 0);
    Duration dark = end - begin;
    for (std::size_t i = 0; i < seen_.size(); ++i) {
        const TimePoint until = i + 1 < seen_.size() ? std::min(end, seen_[i + 1].from) : end;
        const Duration length = until - std::max(begin, seen_[i].from);
        if (length <= Duration{0}) continue;
        dark -= length;
        const float share =
            static_cast<float>(length.count()) / static_cast<float>((end - begin).count());
        for (std::size_t pixel = 0; pixel < sum.size(); ++pixel)
            sum[pixel] += share * seen_[i].levels[pixel];
    }
    const float share =
        static_cast<float>(dark.count()) / static_cast<float>((end - begin).count());
    for (float& level : sum)
        level += share * kRoom;
    return sum;
}

ReadResult PanelWatcher::read(TimePoint deadline) noexcept {
    const Duration period(std::llround(1e9 / panel_.fps));
    const Duration half = panel_.exposure / 2;
    const auto captured = [&] { return startedAt_ + static_cast<Duration::rep>(next_) * period; };
    const TimePoint now = clock_.now();
    while (captured() + half + panel_.transfer + period <= now)
        ++next_; // nobody read it in time
    const TimePoint ready = captured() + half + panel_.transfer;
    clock_.sleepUntil(std::min(ready, deadline));
    if (ready > deadline) return Timeout{};
    FrameMetadata metadata;
    metadata.format = PixelFormat::Rgba8;
    metadata.width = kWidth;
    metadata.height = kHeight;
    metadata.sequence = next_++;
    metadata.capturedAt = ready - panel_.transfer - half;
    std::optional<Frame> frame = pool_.acquire(metadata);
    if (!frame) {
        ++counters_.starved;
        return Timeout{};
    }
    const Levels levels = exposed(metadata.capturedAt - half, metadata.capturedAt + half);
    const std::uint64_t key = hashBits(panel_.seed, metadata.sequence);
    const auto pixels = frame->pixels();
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const float noisy = levels[i] + kSigma * gaussianFrom(hashBits(key, i));
        const auto level = static_cast<std::byte>(std::lround(std::clamp(noisy, 0.0F, 255.0F)));
        std::fill_n(pixels.begin() + static_cast<std::ptrdiff_t>(4 * i), 3, level);
        pixels[4 * i + 3] = std::byte{255};
    }
    ++counters_.delivered;
    return std::move(*frame);
}

} // namespace autostereo::devices::sim
