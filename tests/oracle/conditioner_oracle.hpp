#pragma once

#include "calib/camera_model.hpp"
#include "gpu/params.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

// Slow, obvious twin of DepthConditioner. Whole numbers decide there, so here too: tests demand
// equality. Units: counts, sigma in 1/16 counts, held values and residuals in 1/256 counts.

namespace autostereo::oracle {

struct Measurement {
    std::int64_t count = 0;
    std::int64_t sigma = 0;
};

template<class Value>
struct Grid {
    int width = 0, height = 0;
    std::vector<Value> values;

    Grid(int w, int h) : width(w), height(h), values(static_cast<std::size_t>(w * h)) {}
    [[nodiscard]] bool has(int x, int y) const {
        return x >= 0 && y >= 0 && x < width && y < height;
    }
    [[nodiscard]] Value& at(int x, int y) {
        const int pixel = y * width + x;
        return values[static_cast<std::size_t>(pixel)];
    }
    [[nodiscard]] const Value& at(int x, int y) const {
        const int pixel = y * width + x;
        return values[static_cast<std::size_t>(pixel)];
    }
};

using Measurements = Grid<std::optional<Measurement>>;

class Conditioner {
  public:
    Conditioner(const gpu::ConditionParams& params, const gpu::DepthMeshParams& range,
                const calib::CameraModel& camera, int width, int height, double unitM = 0.001)
        : params_(params), range_(range), unitM_(unitM), held_(width, height),
          shown_(width, height) {
        const double slope =
            std::tan(params.grazingRad) / camera.resized(width, height).intrinsics.fx;
        slope_ = std::llround(std::fmin(4096 * slope, 4096));
    }

    /// `amplitude` may be empty.
    std::vector<std::uint16_t> operator()(const std::vector<std::uint16_t>& counts,
                                          const std::vector<std::uint16_t>& amplitude) {
        Measurements now = measured(counts, amplitude);
        if (params_.flyingPixels) now = withoutFlying(now);
        if (params_.hold) now = held(now);
        if (params_.fillHoles) now = filled(now);
        std::vector<std::uint16_t> clean;
        for (const auto& pixel : now.values)
            clean.push_back(static_cast<std::uint16_t>(pixel ? pixel->count : 0));
        return clean;
    }

  private:
    struct Held {
        std::int64_t value = 0;
        int frames = 0; ///< 0: nothing is held
        std::int64_t meanResidual = 0;
        std::int64_t sigma = 0;
        int waited = 0;

        [[nodiscard]] Measurement measurement() const { return {(value + 128) / 256, sigma}; }
    };

    /// A number is known to its upper five bits: the middle of those that share them.
    static double middleOfBin(int number) {
        int dropped = 0;
        while ((number >> dropped) >= 32)
            ++dropped;
        const int low = number >> dropped << dropped;
        return low + ((1 << dropped) - 1) / 2.0;
    }

    [[nodiscard]] std::int64_t sigmaOf(int count, std::optional<int> amplitude) const {
        const double sigmaM = params_.confidence && amplitude
                                  ? params_.noise.sigmaAtAmplitudeM(middleOfBin(*amplitude))
                                  : params_.noise.sigmaAtRangeM(middleOfBin(count) * unitM_);
        return std::llround(std::fmin(std::fmax(std::round(16 * sigmaM / unitM_), 1), 32767));
    }

    [[nodiscard]] Measurements measured(const std::vector<std::uint16_t>& counts,
                                        const std::vector<std::uint16_t>& amplitudes) const {
        Measurements result(held_.width, held_.height);
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const int count = counts[i];
            if (count == 0 || count == 65535) continue;
            std::optional<int> amplitude;
            if (!amplitudes.empty()) amplitude = amplitudes[i];
            if (params_.validity) {
                const double z = count * unitM_;
                if (z < range_.nearestM - 1e-9 || z > range_.farthestM + 1e-9) continue;
                if (amplitude && (*amplitude < params_.weakestAmplitude ||
                                  *amplitude >= params_.saturatedAmplitude))
                    continue;
            }
            result.values[i] = {count, sigmaOf(count, amplitude)};
        }
        return result;
    }

    [[nodiscard]] bool oneSurface(Measurement a, Measurement b, int pixels) const {
        const std::int64_t step = std::abs(a.count - b.count);
        const std::int64_t slope = std::min(a.count, b.count) * slope_ * pixels / 4096;
        const std::int64_t edge = std::llround(16 * params_.edgeSigmas);
        return step <= slope || step <= edge * (a.sigma + b.sigma) / 512;
    }

    [[nodiscard]] Measurements withoutFlying(const Measurements& all) const {
        Measurements left = all;
        for (int round = 0; round < 2; ++round) {
            const Measurements before = left;
            for (int y = 0; y < all.height; ++y)
                for (int x = 0; x < all.width; ++x)
                    if (before.at(x, y) && flies(all, before, x, y)) left.at(x, y).reset();
        }
        return left;
    }

    [[nodiscard]] bool flies(const Measurements& all, const Measurements& left, int x,
                             int y) const {
        const Measurement own = *all.at(x, y);
        bool nearer = false, farther = false;
        int supporters = 0;
        for (int j = y - 1; j <= y + 1; ++j)
            for (int i = x - 1; i <= x + 1; ++i) {
                if ((i == x && j == y) || !all.has(i, j) || !all.at(i, j)) continue;
                const Measurement other = *all.at(i, j);
                const bool same = oneSurface(own, other, 1);
                if (same && left.at(i, j)) ++supporters;
                if (!same && other.count < own.count) nearer = true;
                if (!same && other.count > own.count) farther = true;
            }
        return nearer && farther && supporters < 2;
    }

    [[nodiscard]] std::int64_t gate(const Held& held, Measurement now) const {
        const std::int64_t sigmas = std::llround(16 * params_.gateSigmas);
        const std::int64_t gate = sigmas * std::max(held.sigma, now.sigma);
        const std::int64_t widened = gate + gate / (2 * held.frames);
        return held.frames < params_.settleFrames ? widened - 3 * widened / 8 : widened;
    }
    [[nodiscard]] bool withinGate(const Held& held, Measurement now) const {
        return std::abs(256 * now.count - held.value) <= gate(held, now);
    }

    [[nodiscard]] Measurements held(const Measurements& now) {
        Grid<Held> next = held_;
        for (int y = 0; y < now.height; ++y)
            for (int x = 0; x < now.width; ++x) {
                Held& held = next.at(x, y);
                if (isKept(now, x, y)) {
                    ++held.waited;
                } else {
                    held = now.at(x, y) ? updated(held, *now.at(x, y)) : Held{};
                }
                show(held, shown_.at(x, y));
            }
        held_ = next;
        return shown_;
    }

    /// While a value settles, it is shown anew where a quarter of sigma lies between.
    void show(const Held& held, std::optional<Measurement>& shown) const {
        const bool settling = held.frames > 1 && held.frames < params_.settleFrames;
        if (held.frames == 0)
            shown.reset();
        else if (!settling || !shown || std::abs(256 * shown->count - held.value) > 4 * held.sigma)
            shown = held.measurement();
    }

    [[nodiscard]] Held updated(Held held, Measurement now) const {
        if (held.frames == 0 || !withinGate(held, now))
            return {256 * now.count, 1, 0, now.sigma, 0};
        held.waited = 0;
        const std::int64_t n = held.frames + 1;
        if (held.frames < params_.settleFrames) {
            held.value = (held.value * held.frames + 256 * now.count + n / 2) / n;
            held.sigma = (held.sigma * held.frames + now.sigma + n / 2) / n;
            ++held.frames;
            return held;
        }
        const std::int64_t off = 256 * now.count - held.value - held.meanResidual;
        held.meanResidual += static_cast<std::int64_t>(std::floor(static_cast<double>(off) / 16));
        if (std::abs(held.meanResidual) <= 28 * held.sigma) return held; // 1.75 sigma
        held.value += held.meanResidual;
        held.frames = std::max(1, params_.settleFrames / 4);
        held.meanResidual = 0;
        return held;
    }

    [[nodiscard]] bool isKept(const Measurements& now, int x, int y) const {
        const Held own = held_.at(x, y);
        const auto measurement = now.at(x, y);
        if (own.frames == 0 || own.waited >= params_.keepFrames) return false;
        if (measurement && withinGate(own, *measurement)) return false;
        int holding = 0, changed = 0, agreeing = 0;
        bool between = false;
        for (int j = y - 2; j <= y + 2; ++j)
            for (int i = x - 2; i <= x + 2; ++i) {
                if ((i == x && j == y) || !now.has(i, j) || !now.at(i, j)) continue;
                const Measurement other = *now.at(i, j);
                const Held held = held_.at(i, j);
                const int steps = std::max(std::abs(i - x), std::abs(j - y));
                const bool isHeld = held.frames > 0;
                if (isHeld && oneSurface(own.measurement(), held.measurement(), steps))
                    ++(withinGate(held, other) ? holding : changed);
                if (!measurement || oneSurface(own.measurement(), other, steps)) continue;
                if (oneSurface(other, *measurement, steps)) {
                    if (isHeld && oneSurface(held.measurement(), *measurement, steps)) ++agreeing;
                } else if (256 * measurement->count > own.value) {
                    between = between || other.count > measurement->count;
                } else {
                    between = between || other.count <= measurement->count;
                }
            }
        const bool still = holding > 0 && holding >= changed;
        return still && (!measurement || (between && agreeing < 2));
    }

    [[nodiscard]] Measurements filled(const Measurements& now) const {
        Measurements result = now;
        for (int y = 0; y < now.height; ++y)
            for (int x = 0; x < now.width; ++x)
                if (!now.at(x, y)) result.at(x, y) = fill(now, x, y);
        return result;
    }

    [[nodiscard]] std::optional<Measurement> fill(const Measurements& now, int x, int y) const {
        std::int64_t farthest = 0;
        std::pair<int, std::int64_t> narrowest{1000, 0}; // width; less count
        for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
            const auto [a, toA] = end(now, x, y, -dx, -dy);
            const auto [b, toB] = end(now, x, y, dx, dy);
            const int gap = toA + toB;
            if (!a || !b || gap - 1 > params_.holeWidth) continue;
            farthest = std::max({farthest, a->count, b->count});
            if (!oneSurface(*a, *b, gap)) continue;
            const std::int64_t between = (a->count * toB + b->count * toA + gap / 2) / gap;
            narrowest = std::min(narrowest, {gap, -between});
        }
        if (narrowest.second != 0) return Measurement{-narrowest.second, 0};
        if (farthest != 0) return Measurement{farthest, 0};
        return std::nullopt;
    }

    [[nodiscard]] std::pair<std::optional<Measurement>, int> end(const Measurements& now, int x,
                                                                 int y, int dx, int dy) const {
        for (int steps = 1; steps <= params_.holeWidth; ++steps) {
            const int i = x + steps * dx, j = y + steps * dy;
            if (now.has(i, j) && now.at(i, j)) return {now.at(i, j), steps};
        }
        return {std::nullopt, 0};
    }

    gpu::ConditionParams params_;
    gpu::DepthMeshParams range_;
    double unitM_;
    std::int64_t slope_ = 0;
    Grid<Held> held_;
    Measurements shown_;
};

} // namespace autostereo::oracle
