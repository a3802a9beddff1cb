#pragma once

#include "calib/display_profile.hpp"
#include "config/toml_reader.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace autostereo::config {

// Ranges that display files and vendors' calibrations share.
constexpr Range kPanelPixels{16, 16384};
constexpr Range kConeDeg{1, 120};
namespace cubevi {
constexpr Range kSubpixelsPerLens{1, 1000};
constexpr Range kSlope{-10, 10};
constexpr Range kOffset{-1000, 1000};
} // namespace cubevi

/// A display file being read into a profile: what the readers of each family share. Every number
/// that describes the glass must be there and have its origin under [provenance]; what the picture
/// is made of (views, quilt, budget) is a choice and needs none.
struct DisplayReader {
    DisplayReader(const std::string& file, std::string_view text) : root(file, text) {}

    /// A physical number with its origin.
    double physical(TomlReader& table, std::string_view key, Range range);
    /// The lens sits differently on every unit: a number from anywhere but this one is a
    /// placeholder.
    double lensNumber(TomlReader& table, std::string_view key, Range range);
    void noteLensOrigin(std::string_view key);

    TomlReader root;
    TomlReader provenance = root.table("provenance");
    calib::DisplayProfile profile;
    std::filesystem::path folder; ///< what other files are named relative to

  private:
    std::string origin(std::string_view key);
};

/// [phase_grid], of any lens or barrier whose phase is affine (for each eye); absent: empty.
[[nodiscard]] calib::PhaseGrid readPhaseGrid(DisplayReader& display);

// One reader per family of display laws, in read_*_laws.cpp.
[[nodiscard]] calib::LinearPhase readLinear(DisplayReader& display);
[[nodiscard]] calib::VanBerkelLens readVanBerkel(DisplayReader& display);
[[nodiscard]] calib::LookingGlassCalibration readLookingGlass(DisplayReader& display);
[[nodiscard]] calib::CubeviCalibration readCubevi(DisplayReader& display);
[[nodiscard]] calib::ViewTable readTable(DisplayReader& display);
[[nodiscard]] calib::ViewLut readLut(DisplayReader& display);
[[nodiscard]] calib::LineScreen readLineScreen(DisplayReader& display);
[[nodiscard]] calib::TrackedLens readTrackedLens(DisplayReader& display);
[[nodiscard]] calib::DepthFrame readDepthFrame(DisplayReader& display);
/// side_by_side, top_bottom, row, column, checkerboard, anaglyph, flat, quilt.
[[nodiscard]] calib::DisplayLaw readFrame(DisplayReader& display, std::string_view type);

} // namespace autostereo::config
