#pragma once

#include <array>
#include <map>
#include <string>

namespace autostereo::calib {

/// How the vendor's view number moves when the eye moves right.
enum class ViewOrder { LeftToRight, RightToLeft };

/// Where view i of N sits on the fan b in [-1, 1]:
/// Centres: b = (2i + 1)/N - 1; Edges: b = 2i/(N - 1) - 1 (outermost cameras at +-1).
enum class Fan { Centres, Edges };

/// phase(x, y, c) = perColumn * x + perRow * y + channel[c] + offset, in cycles (lens periods),
/// wrapping; x and y are pixel indices from the top left, c = 0, 1, 2 for R, G, B.
/// Vendor's view = floor(views * phase).
struct LinearPhase {
    double perColumn = 0;
    double perRow = 0;
    std::array<double, 3> channel{};
    double offset = 0;
};

/// Tiles of a quilt: view 0 bottom left, rows left to right, bottom to top. Sizes in pixels.
struct QuiltLayout {
    int columns = 1;
    int rows = 1;
    int tileWidth = 0;
    int tileHeight = 0;
};

/// What the glass is. Plain numbers, in SI units; built by `config` from displays/*.toml.
struct DisplayProfile {
    std::string name;         ///< file stem, e.g. "looking-glass-portrait"
    std::string model;        ///< for people
    std::string type;         ///< "linear", "van_berkel", "looking_glass", "preview"
    bool placeholder = false; ///< true: template numbers, a per-unit file should replace them

    int width = 0; ///< native mode in pixels; 0: whatever mode the monitor has ("preview")
    int height = 0;
    double widthM = 0;           ///< active area
    double viewingDistanceM = 0; ///< D, nominal
    double coneRad = 0;          ///< fan angle seen from the panel's centre
    int views = 1;
    ViewOrder order = ViewOrder::LeftToRight;
    Fan fan = Fan::Centres;
    LinearPhase phase;
    QuiltLayout quilt;

    /// Disparity that the display can show sharply, in panel widths at the extreme view
    /// (|b| = 1): far < 0 < near.
    double disparityFar = -0.05;
    double disparityNear = 0.05;

    /// key -> "per-unit", "template", "measured" or "assumed"
    std::map<std::string, std::string> provenance;

    [[nodiscard]] double heightM() const { return widthM * height / width; }
};

} // namespace autostereo::calib
