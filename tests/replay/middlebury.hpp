#pragma once

#include "tests/replay/pictures.hpp"

#include <filesystem>
#include <ostream>
#include <vector>

namespace autostereo::test {

/// Two rectified pictures of one of Middlebury's sets: what the left one's camera sees, and what
/// one `baselines` times as far to the right as its disparity is given for does.
struct StereoPair {
    const char *name, *folder;
    const char *left, *right, *leftDisparity;
    const char* rightDisparity; ///< null: the set has none
    int greyPerPixel;
    double baselines = 1;
    int border = 0;                           ///< pixels without truth on every side, cut off
    double leastSeenDb = 0, leastAllDb = 0;   ///< 0: stated only
    double leastGainDb = -1, leastRowDb = -1; ///< over what libraries do; -1: stated only
};

// NOLINTNEXTLINE(readability-identifier-naming)
inline void PrintTo(const StereoPair& pair, std::ostream* out) { *out << pair.name; }

/// Rows of one number a pixel.
using Plane = std::vector<std::vector<double>>;

/// What reaches the other camera of a picture with disparity: each of its pixels' place in the row
/// (-1: nothing does) and disparity. In double precision, surfaces cut at steps of over a pixel.
struct Warp {
    Plane source, disparity;
};
[[nodiscard]] Warp warp(const Plane& disparity, double baselines);

/// The pair read, and what is known of its right picture's pixels.
class StereoTruth {
  public:
    /// Throws std::runtime_error.
    StereoTruth(const StereoPair& pair, const std::filesystem::path& folder);

    ColorPicture left, right;
    Plane disparity; ///< of the left, unknown pixels as far as the farther neighbour in their row

    /// The left camera sees it too: both disparities say the same to a pixel.
    [[nodiscard]] bool seen(int x, int y) const;
    /// Beside what the left camera sees.
    [[nodiscard]] bool outOfFrame(int x, int y) const;
    /// Behind something that hides it from the left camera.
    [[nodiscard]] bool disoccluded(int x, int y) const { return !seen(x, y) && !outOfFrame(x, y); }

  private:
    double baselines_;
    Plane known_, other_, otherFilled_; ///< 0: unknown
};

/// How holes of a plain warp are filled.
enum class HoleFilling { Telea, RowsFartherEnd };
/// The left picture warped by bicubic interpolation, to whole pixels, its holes filled.
[[nodiscard]] ColorPicture plainWarp(const StereoTruth& truth, double baselines,
                                     HoleFilling filling);

} // namespace autostereo::test
