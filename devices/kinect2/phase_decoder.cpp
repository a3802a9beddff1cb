#include "devices/kinect2/phase_decoder.hpp"

#include "devices/kinect2/vectorised.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace autostereo::devices::kinect2 {

namespace {

constexpr double kBaselineMm = 45; // from lens to laser, along x
constexpr double kMmPerM = 1000;
constexpr double kSteepest = 100; // x/z, y/z
/// Margin (chi squared) at which the confidence is a half.
constexpr float kHalfMargin = 16;
constexpr int kOverexposed = 65535;

/// Paths there and back.
double pathUnits(double rangeM) { return 2 * rangeM * kMmPerM / kUnitMm; }

/// The laser, the surface and the lens make a triangle of which two sides' sum is known. 0 for
/// pixels without a ray (no stretch).
AUTOSTEREO_VECTORISED
void triangulate(const ChosenRow& chosen, const float* stretch, const float* sideways,
                 float zOffsetMm, float* depth) {
    constexpr auto kBaseline = static_cast<float>(kBaselineMm);
    for (std::size_t x = 0; x < kWidth; ++x) {
        const float path = chosen.path[x] * static_cast<float>(kUnitMm);
        const float z = (path * path - kBaseline * kBaseline) /
                        (2 * (path * stretch[x] - sideways[x] * kBaseline));
        depth[x] = stretch[x] > 0 ? z + zOffsetMm : 0;
    }
}

/// Fills in confidences and takes away depths that are none.
AUTOSTEREO_VECTORISED
void rate(const PhaseRow& phases, const ChosenRow& chosen, const DepthLimits& limits, float* depth,
          float* confidence) {
    for (std::size_t x = 0; x < kWidth; ++x) {
        const float margin = chosen.margin[x], path = chosen.path[x];
        const float measured = phases.strongest[x] != kSaturated && depth[x] != 0 ? 1.0F : 0.0F;
        const float sure = measured * margin / (margin + kHalfMargin);
        const float light = std::min(std::min(phases.amplitudes[0][x], phases.amplitudes[1][x]),
                                     phases.amplitudes[2][x]);
        float kept = sure >= limits.confidence ? depth[x] : 0;
        kept = light >= limits.amplitude ? kept : 0;
        kept = path >= limits.leastPath ? kept : 0;
        kept = path <= limits.mostPath ? kept : 0;
        depth[x] = measured * kept;
        confidence[x] = sure;
    }
}

AUTOSTEREO_VECTORISED
void showInfrared(const PhaseRow& phases, std::uint16_t* infrared) {
    constexpr float kGain = 16.0F / kFrequencies;
    for (std::size_t x = 0; x < kWidth; ++x) {
        const float sum =
            phases.amplitudes[0][x] + phases.amplitudes[1][x] + phases.amplitudes[2][x];
        const int light = static_cast<int>(std::min(sum * kGain, 65534.0F));
        infrared[x] =
            static_cast<std::uint16_t>(phases.strongest[x] == kSaturated ? kOverexposed : light);
    }
}

/// Rows of hypotheses around the one being decided, used in turns.
struct Window {
    std::array<WrapRow, 3> rows;
    std::array<PhaseRow, 2> phases; ///< of the row being decided and the one below
    ChosenRow chosen;
};

} // namespace

PhaseDecoder::PhaseDecoder(PhaseCalibration calibration, const DepthCamera& camera,
                           const DecodeParams& params)
    : calibration_(std::move(calibration)),
      wraps_(calibration_.amplitudeFactors, params.noise, pathUnits(params.nearestM),
             pathUnits(params.farthestM)),
      limits_{static_cast<float>(params.leastConfidence), static_cast<float>(params.leastAmplitude),
              static_cast<float>(pathUnits(params.nearestM)),
              static_cast<float>(pathUnits(params.farthestM))},
      zOffsetMm_(static_cast<float>(camera.zOffsetMm)), stretch_(kPixels), sideways_(kPixels) {
    for (std::size_t pixel = 0; pixel < kPixels; ++pixel) {
        const std::size_t x = pixel % kWidth, y = pixel / kWidth;
        if (x == 0 || x == kWidth - 1) continue; // not measured
        const auto ray = camera.model.unproject({static_cast<double>(x), static_cast<double>(y)});
        // A lens that bends light more than this is garbage, and floats would overflow.
        if (!ray || std::hypot(ray->x, ray->y) > kSteepest) continue;
        stretch_[pixel] = static_cast<float>(std::hypot(ray->x, ray->y, 1.0));
        sideways_[pixel] = static_cast<float>(ray->x);
    }
    for (const std::uint32_t defect : calibration_.defects)
        stretch_[defect] = 0;
}

void PhaseDecoder::decode(const RawDepthFrame& frame, DepthPicture& picture) const {
    const auto window = std::make_unique<Window>();
    for (WrapRow& row : window->rows)
        row.clear();
    const auto fetch = [&](int row) {
        PhaseRow& phases = window->phases[static_cast<std::size_t>(row % 2)];
        measurePhases(frame, calibration_, row, phases);
        wraps_.find(phases, window->rows[static_cast<std::size_t>(row % 3)]);
    };
    fetch(0);
    for (int row = 0; row < kHeight; ++row) {
        auto& below = window->rows[static_cast<std::size_t>((row + 1) % 3)];
        if (row + 1 < kHeight)
            fetch(row + 1);
        else
            below.clear();
        chooseWraps(window->rows[static_cast<std::size_t>((row + 2) % 3)],
                    window->rows[static_cast<std::size_t>(row % 3)], below, window->chosen);
        writeRow(row, window->phases[static_cast<std::size_t>(row % 2)], window->chosen, picture);
    }
}

void PhaseDecoder::writeRow(int row, const PhaseRow& phases, const ChosenRow& chosen,
                            DepthPicture& picture) const {
    const std::size_t first = static_cast<std::size_t>(row) * kWidth;
    const auto line = [first](auto& plane) { return plane.data() + first; };
    triangulate(chosen, line(stretch_), line(sideways_), zOffsetMm_, line(picture.depthMm));
    rate(phases, chosen, limits_, line(picture.depthMm), line(picture.confidence));
    showInfrared(phases, line(picture.infrared));
}

} // namespace autostereo::devices::kinect2
