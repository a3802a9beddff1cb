#pragma once

#include "calib/display_laws.hpp"

#include <map>
#include <string>
#include <vector>

namespace autostereo::calib {

/// How the vendor's view number moves when the eye moves right.
enum class ViewOrder { LeftToRight, RightToLeft };

/// Where view i of N sits on the fan b in [-1, 1]:
/// Centres: b = (2i + 1)/N - 1; Edges: b = 2i/(N - 1) - 1 (outermost cameras at +-1).
enum class Fan { Centres, Edges };

/// Tiles of a quilt: view 0 bottom left, rows left to right, bottom to top. Sizes in pixels.
struct QuiltLayout {
    int columns = 1;
    int rows = 1;
    int tileWidth = 0;
    int tileHeight = 0;
};

/// The light's way from the pixels to an eye, where the law alone does not say it.
struct Optics {
    enum class Kind { None, Lens, Slit };
    Kind kind = Kind::None;
    double gapM = 0;     ///< lens or slit to pixels, air-equivalent; 0: follows from the fan
    double aperture = 0; ///< width that an eye sees through a lens or slit, cycles
};

/// What the glass is. Plain numbers, in SI units; built by `config` from displays/*.toml.
struct DisplayProfile {
    std::string name;         ///< file stem, e.g. "looking-glass-portrait"
    std::string model;        ///< for people
    std::string type;         ///< as in its file: "linear", "van_berkel", "looking_glass", ...
    bool placeholder = false; ///< true: template numbers, a per-unit file should replace them
    std::vector<std::string> edidNames; ///< monitor names that it may have; * at the end: any rest

    int width = 0; ///< native mode in pixels; 0: whatever mode the monitor has
    int height = 0;
    double widthM = 0;           ///< active area
    double viewingDistanceM = 0; ///< D, nominal
    double coneRad = 0;          ///< fan angle seen from the panel's centre
    int views = 1;               ///< that are drawn
    ViewOrder order = ViewOrder::LeftToRight;
    Fan fan = Fan::Centres;
    DisplayLaw law;
    /// What each vendor's view shows: a view from the left, or kBlack (masks such as LLRRb). Empty:
    /// each its own.
    std::vector<int> remap;
    Optics optics;
    int fringe = 0; ///< pixels over which the panel's border fades to black
    QuiltLayout quilt;

    /// Disparity that the display can show sharply, in panel widths at the extreme view
    /// (|b| = 1): far < 0 < near.
    double disparityFar = -0.05;
    double disparityNear = 0.05;

    /// key -> "per-unit", "template", "measured" or "assumed"
    std::map<std::string, std::string> provenance;
    std::map<std::string, std::string> notes; ///< what an importer found and nothing uses

    static constexpr int kBlack = -1;

    [[nodiscard]] double heightM() const { return widthM * height / width; }
};

} // namespace autostereo::calib
