#pragma once

#include "devices/kinect2/phase_row.hpp"

#include <array>

namespace autostereo::devices::kinect2 {

// Which of its wraps each phase is in. Light paths are measured in units of 1250 mm, in which the
// three frequencies repeat every 3, 15 and 2, and all together every 30.

inline constexpr double kUnitMm = 1250;
inline constexpr std::array<double, kFrequencies> kPeriods{3, 15, 2};

/// How much to trust a phase.
struct PhaseNoise {
    double sampleSigma = 8;   ///< standard deviation of one raw sample, counts
    double systematic = 0.03; ///< radians that do not shrink with light: harmonics, quantisation
};

/// For each pixel of a row the two likeliest of all 30 combinations of wraps, the likelier first.
/// `misfit`: how badly the phases agree there, chi squared with two degrees of freedom. One pixel
/// more on either side, which agrees with nothing.
struct WrapRow {
    static constexpr std::size_t kPadded = kWidth + 2;
    using Line = std::array<float, kPadded>;
    alignas(64) std::array<Line, 2> path; ///< units; about -1 to 31
    alignas(64) std::array<Line, 2> misfit;

    /// Agrees with nothing: what lies beyond the picture.
    void clear();
};

/// Makes hypotheses. `leastPath` and `mostPath` bound what is likely, units. Reentrant.
class WrapFinder {
  public:
    WrapFinder(const std::array<double, kFrequencies>& amplitudeFactors, const PhaseNoise& noise,
               double leastPath, double mostPath);
    void find(const PhaseRow& phases, WrapRow& result) const;

  private:
    float weight0_, weight1_, weight2_; ///< of the frequencies' paths, sum 1
    float sampleVariance_;              ///< as phase, rad^2 at an amplitude of 1
    float systematicVariance_;          ///< rad^2
    float misfitScale_;
    float least_, most_;
};

/// The likelier path of each pixel given its eight neighbours, each of which speaks for the
/// hypothesis that continues one of its own, up to a limit, so that edges hold. `margin`: by how
/// much chi squared the other hypothesis is worse.
struct ChosenRow {
    alignas(64) std::array<float, kWidth> path;
    alignas(64) std::array<float, kWidth> margin;
};
void chooseWraps(const WrapRow& above, const WrapRow& own, const WrapRow& below, ChosenRow& result);

} // namespace autostereo::devices::kinect2
