#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace autostereo::devices {

/// What a monitor says about itself (VESA E-EDID 1.x base block, CEA-861 extensions). A field that
/// the monitor leaves out is empty, 0 or false.
struct Edid {
    std::string manufacturer; ///< three capital letters of the PNP registry, "DEL"
    std::uint16_t product = 0;
    std::uint32_t serialNumber = 0;
    std::string monitorName; ///< descriptor FC, printable ASCII, at most 13 characters
    std::string serialText;  ///< descriptor FF, likewise

    // The preferred detailed timing.
    int nativeWidth = 0; ///< pixels, up to 4095; wider panels state theirs in their modes only
    int nativeHeight = 0;
    double refreshHz = 0;
    bool interlaced = false;
    double widthM = 0; ///< picture area, metres; 0 (projectors) where unknown
    double heightM = 0;

    bool digital = false;
    int bitsPerChannel = 0; ///< EDID 1.4 and later: 6 to 16, 0: not said

    // CEA-861 extension: a monitor without one is driven as DVI, in RGB and full range.
    bool cea = false;
    bool hdmi = false;
    bool ycbcr444 = false;
    bool ycbcr422 = false;
    bool ycbcr420 = false;
    bool underscans = false;             ///< shows PC timings whole unless told otherwise
    bool alwaysOverscans = false;        ///< says that it cuts PC timings' edges off
    bool quantisationSelectable = false; ///< obeys the range that the source declares for RGB

    /// Extensions that are missing or damaged, one sentence each; the base block is good.
    std::vector<std::string> faults;
};

struct EdidError {
    std::string text; ///< "edid: checksum of the base block is 17, not 0"
};

/// Takes any bytes; more than 256 blocks are refused. Reentrant, never throws but for memory.
[[nodiscard]] std::variant<Edid, EdidError> parseEdid(std::span<const std::byte> bytes);

/// Looking Glass displays call themselves LKG..., whoever made the bridge chip.
[[nodiscard]] bool isLookingGlass(const Edid& edid);

} // namespace autostereo::devices
