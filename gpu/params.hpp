#pragma once

#include "calib/depth_budget.hpp"
#include "calib/depth_noise.hpp"
#include "calib/framing.hpp"

#include <array>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace autostereo::gpu {

/// How the views come to the panel: searched for by each of its sub-pixels, or drawn into tiles.
/// Auto: whichever is fastest here (views/method_choice.hpp).
enum class Method { Auto, Direct, Instanced, Multipass, Geometry, Layered, Hybrid };
/// As configurations, command lines and reports say them.
inline constexpr std::array<std::pair<std::string_view, Method>, 7> kMethods{
    {{"auto", Method::Auto},
     {"direct", Method::Direct},
     {"instanced", Method::Instanced},
     {"multipass", Method::Multipass},
     {"geometry", Method::Geometry},
     {"mrt", Method::Layered},
     {"hybrid", Method::Hybrid}}};
[[nodiscard]] constexpr std::string_view methodName(Method method) {
    for (const auto& [name, known] : kMethods)
        if (known == method) return name;
    return kMethods.front().first;
}
/// How a sub-pixel reads its tile.
enum class TileFilter { Nearest, Linear };
/// Eyes that the direct method shows: those of the display's views, or one for every phase.
enum class ViewPositions { OfViews, Continuous };
/// What a sub-pixel shows between two views: the one whose interval it lies in, or a mix that goes
/// over to the next view across that interval (as Looking Glass's own players have it).
enum class ViewFilter { Nearest, Blend };

struct DepthMeshParams {
    double nearestM = 0.15; ///< depth outside [nearest, farthest] counts as no measurement
    double farthestM = 100.0;
    /// A triangle whose farthest corner is more than this fraction farther than its nearest one
    /// bridges two surfaces and is cut.
    double cutRatio = 0.05;
};

/// What DepthConditioner does to a depth picture; each step can be left out.
struct ConditionParams {
    /// Refuse counts outside DepthMeshParams' range, and amplitudes outside [weakest, saturated).
    bool validity = true;
    int weakestAmplitude = 20;
    int saturatedAmplitude = 65535;

    /// Take the noise from the amplitude where there is one, else from the range.
    bool confidence = true;
    calib::DepthNoise noise;

    /// Remove measurements between two surfaces that belong to neither.
    bool flyingPixels = true;
    /// Neighbours belong to one surface if it need not be seen more grazing than this (90 degrees:
    /// along the ray), or if they are no further apart than so many sigma.
    double grazingRad = 65 * std::numbers::pi / 180;
    double edgeSigmas = 2.5;

    /// Keep the value of a pixel where nothing moved.
    bool hold = true;
    double gateSigmas = 5;
    int settleFrames = 16; ///< averaged before a pixel is held
    int keepFrames = 30;   ///< without a measurement, beside neighbours that are held

    bool fillHoles = true;
    int holeWidth = 3; ///< pixels; wider holes stay
};

/// Of what a colour camera gives, what is taken for noise (ColorHold).
struct ColorHoldParams {
    double sigma = 0; ///< of a byte, levels; 0: every difference shows
};

/// How the measured surfaces become a complete cyclopean picture.
struct FusionParams {
    double density = 1.5;     ///< texels of the cyclopean grid per pixel of the depth camera
    int mostTexels = 200'000; ///< of that grid; fewer per pixel where it would have more
    /// Depth this close to an edge gives way to the colours' decision where the colour camera has
    /// the finer pixels, depth pixels.
    double edgeBandPx = 1;
    double edgeReachPx = 3; ///< so near an edge colours decide between surfaces, depth pixels
    bool remember = true;   ///< background seen earlier; for cameras that stand still
    int fillReach = 128;    ///< farther from every measurement a texel stays empty, texels
};

struct RegistrationParams {
    /// At the mesh's border, and at cuts for the farther surface, measured depth goes on for so
    /// many depth pixels beyond the last one's own square, never over anything measured.
    int extrudePx = 1;
};

struct DepthBudgetParams {
    /// Camera depth shown in the panel's plane; none: median depth of the first picture's central
    /// third.
    std::optional<double> focusM;
    /// Multiplies the natural scale (cameras' width at the focus = panel width); none: 1.
    std::optional<double> depthScale;

    /// What is none above follows the scene instead (DepthBudget), within the limits.
    bool follow = false;
    calib::PlacementLimits limits;
    calib::PlacementFollower::Motion motion;
    /// Of what the panel shows, so much is nearer than what the budget has to hold, and so much not
    /// farther; of its central third, so much is nearer than the panel's plane. 0..1.
    double nearShare = 0.05;
    double farShare = 0.95;
    double subjectShare = 0.3;
};

/// What stands in place of everything beyond a distance.
struct BackdropParams {
    double cutM = 0; ///< farther surfaces are not shown, metres at the colour camera; 0: all are
    /// 8-bit R, G, B, 255, top row first; fills the panel, cropped to its shape. One pixel: a
    /// colour.
    int width = 1;
    int height = 1;
    std::vector<std::uint8_t> pixels{0, 0, 0, 255};
};

struct SynthesisParams {
    Method method = Method::Direct;
    TileFilter filter = TileFilter::Linear;
    ViewFilter views = ViewFilter::Nearest;
    ViewPositions positions = ViewPositions::Continuous;
    bool keepRoots = true; ///< direct: search only where something changed
    double leastDb = 40;   ///< auto: PSNR against the exact panel, at least
    double tileScale = 1;  ///< of the display's tiles, each way (Kooima 2007's quality, squared)
    int viewsPerPass = 0;  ///< geometry, layered: 0: as many as the driver allows
    int references = 3;    ///< hybrid: 2 to 5
    /// Two eyes that move, on displays that follow them: EyeSynthesis, whatever the method.
    bool followEyes = false;
};

struct PipelineParams {
    ConditionParams condition;
    ColorHoldParams color;
    DepthMeshParams mesh;
    FusionParams fusion;
    RegistrationParams registration;
    DepthBudgetParams budget;
    calib::FramingChoice framing;
    BackdropParams backdrop;
    SynthesisParams synthesis;
    bool skipUnchanged = true; ///< do again only what a frame changes; else all, to the same bytes
    std::array<double, 3> clearColor{0, 0, 0}; ///< gamma-encoded, 0..1
};

} // namespace autostereo::gpu
