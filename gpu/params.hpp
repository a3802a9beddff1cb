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
    double farthestM = 10.0;
    /// A triangle whose farthest corner is more than this fraction farther than its nearest one
    /// bridges two surfaces and is cut.
    double cutRatio = 0.05;
};

struct RegistrationParams {
    /// At the mesh's border, and at cuts for the farther surface, measured depth goes on for so
    /// many depth pixels beyond the last one's own square, never over anything measured.
    int extrudePx = 1;
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
    RegistrationParams registration;
    DepthBudgetParams budget;
    SynthesisParams synthesis;
    std::array<double, 3> clearColor{0, 0, 0}; ///< gamma-encoded, 0..1
};

} // namespace autostereo::gpu
