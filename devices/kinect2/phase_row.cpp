#include "devices/kinect2/phase_row.hpp"

#include "devices/kinect2/vectorised.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::devices::kinect2 {

namespace {

using Samples = std::array<std::int16_t, kWidth>;

/// atan2(y, x) in turns, -0.5 to 0.5; 0 at the origin. The polynomial interpolates
/// atan(r) / (2 pi r) over r^2 in [0, 1] at Chebyshev points: within 1e-8 turns, 20 nm of depth at
/// 80 MHz, so that float's rounding is what remains. No branches.
inline float atan2Turns(float y, float x) {
    const float ax = std::abs(x), ay = std::abs(y);
    const float longer = std::max(ax, ay), shorter = std::min(ax, ay);
    const float ratio = shorter / std::max(longer, 1e-20F);
    const float r2 = ratio * ratio;
    float sum = -0.000725713434F;
    for (const float term : {0.00378478708F, -0.00936304601F, 0.0157067872F, -0.0222869285F,
                             0.0317784067F, -0.0530492275F, 0.159154924F})
        sum = sum * r2 + term;
    float angle = sum * ratio;
    angle = ay > ax ? 0.25F - angle : angle;
    angle = x < 0 ? 0.5F - angle : angle;
    return y < 0 ? -angle : angle;
}

/// What one frequency says: amplitude = 2/3 |sum of samples times the reference wave|.
AUTOSTEREO_VECTORISED
void demodulate(const std::array<Samples, kShifts>& samples, const std::uint16_t* offsets,
                float factor, PhaseRow::Line& turns, PhaseRow::Line& amplitudes,
                Samples& strongest) {
    constexpr float kHalfRoot3 = 0.866025404F;
    constexpr float kTurnsPerOffset = 1.0F / 65536;
    for (std::size_t x = 0; x < kWidth; ++x) {
        const int m0 = samples[0][x], m1 = samples[1][x], m2 = samples[2][x];
        const auto real = static_cast<float>(2 * m0 - m1 - m2) * 0.5F;
        const auto imaginary = static_cast<float>(m2 - m1) * kHalfRoot3;
        // -0.5 to 1.5: the offset adds less than a turn.
        const float angle =
            atan2Turns(imaginary, real) + static_cast<float>(offsets[x]) * kTurnsPerOffset;
        const float lifted = angle < 0 ? angle + 1 : angle;
        turns[x] = lifted >= 1 ? lifted - 1 : lifted;
        amplitudes[x] = std::sqrt(real * real + imaginary * imaginary) * factor * (2.0F / kShifts);
        strongest[x] =
            std::max(std::max(samples[0][x], samples[1][x]), std::max(samples[2][x], strongest[x]));
    }
}

} // namespace

void measurePhases(const RawDepthFrame& frame, const PhaseCalibration& calibration, int row,
                   PhaseRow& result) {
    std::array<Samples, kShifts> samples;
    result.strongest.fill(0);
    for (std::size_t frequency = 0; frequency < kFrequencies; ++frequency) {
        for (std::size_t shift = 0; shift < kShifts; ++shift)
            unpackRow(frame.subImage(frequency * kShifts + shift), row, samples[shift]);
        demodulate(samples,
                   calibration.offsets[frequency].data() + static_cast<std::size_t>(row) * kWidth,
                   static_cast<float>(calibration.amplitudeFactors[frequency]),
                   result.turns[frequency], result.amplitudes[frequency], result.strongest);
    }
}

} // namespace autostereo::devices::kinect2
