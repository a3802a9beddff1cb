#pragma once

#include <array>
#include <optional>

namespace autostereo::gpu {

/// How the N views come to their tiles.
enum class Method { Instanced, Multipass };
/// How a sub-pixel reads its tile.
enum class TileFilter { Nearest, Linear };
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

/// How the measured surfaces become a complete cyclopean picture.
struct FusionParams {
    double density = 2; ///< texels of the cyclopean grid per pixel of the depth camera
    /// Depth this close to an edge gives way to the colours' decision where the colour camera has
    /// the finer pixels, depth pixels.
    double edgeBandPx = 1;
    double edgeReachPx = 3; ///< so near an edge colours decide between surfaces, depth pixels
    int fillReach = 128;    ///< farther from every measurement a texel stays empty, texels
};

struct DepthBudgetParams {
    /// Camera depth shown in the panel's plane; none: median depth of the picture's central third.
    std::optional<double> focusM;
    /// Multiplies the natural scale (cameras' width at the focus = panel width).
    double depthScale = 1.0;
};

struct SynthesisParams {
    Method method = Method::Instanced;
    TileFilter filter = TileFilter::Linear;
    ViewFilter views = ViewFilter::Nearest;
};

struct PipelineParams {
    DepthMeshParams mesh;
    FusionParams fusion;
    DepthBudgetParams budget;
    SynthesisParams synthesis;
    std::array<double, 3> clearColor{0, 0, 0}; ///< gamma-encoded, 0..1
};

} // namespace autostereo::gpu
