#pragma once

#include "devices/display/edid.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace autostereo::devices {

enum class ColorFormat : std::uint8_t { Rgb, Ycbcr444, Ycbcr422, Ycbcr420 };
enum class ColorRange : std::uint8_t { Full, Limited, Automatic };
/// What a 3x3 colour matrix does to sub-pixels that show different views.
enum class ColorMatrix : std::uint8_t {
    Identity,
    Scaling, ///< each channel by itself
    Mixing   ///< channels into each other: views into each other
};
enum class ModeScaling : std::uint8_t { None, Full, Center, FullAspect };

struct PixelSize {
    int width = 0; ///< pixels
    int height = 0;
    [[nodiscard]] bool operator==(const PixelSize&) const = default;
};

/// What happens to sub-pixels between frame buffer and glass, as far as it is known: whatever is
/// empty could not be read, and nothing is concluded from it. A value; reentrant.
struct LinkState {
    std::optional<int> rotationDeg; ///< 0, 90, 180, 270, by the card, counter-clockwise
    std::optional<bool> reflected;
    std::optional<PixelSize> source; ///< part of the frame buffer that is shown
    std::optional<PixelSize> shown;  ///< what it becomes on the output
    std::optional<PixelSize> mode;   ///< of the output
    std::optional<bool> interlaced;
    std::optional<PixelSize> native; ///< of the monitor
    std::optional<ModeScaling> modeScaling;
    std::optional<PixelSize> border; ///< left black on each side for overscan, pixels

    std::optional<ColorFormat> colorFormat;
    std::optional<std::string> colorSpace; ///< as declared to the monitor, "Default"
    std::optional<ColorRange> range;
    std::optional<bool> gammaIsIdentity;
    std::optional<bool> degammaIsIdentity;
    std::optional<ColorMatrix> colorMatrix;
    std::optional<bool> hdr;
    std::optional<int> maxBitsPerChannel;
    std::optional<bool> dithering;
    std::optional<bool> linkGood; ///< trained at the rate that the mode needs

    // From the EDID.
    std::optional<bool> monitorOverscans;
    std::optional<bool> rangeSelectable; ///< the monitor obeys the declared range
};

struct LinkProblem {
    enum class Severity : std::uint8_t {
        Refuse, ///< views mix: the picture is not worth showing
        Warn    ///< brightness or colour of views suffer, or it cannot be known
    };
    Severity severity = Severity::Warn;
    std::string text; ///< one sentence: what is so, then what to do
    [[nodiscard]] bool operator==(const LinkProblem&) const = default;
};

/// Everything that is wrong with a link, the worst first. Pure.
[[nodiscard]] std::vector<LinkProblem> linkProblems(const LinkState& link);

/// Adds what the monitor says: native size, overscan, range.
void addMonitor(const Edid& edid, LinkState& link);

/// A ramp or look-up table of one channel, 0 to 65535, of any size from 2 up, that changes nothing
/// by more than one step of 8 bits. An empty one means that there is none: identity.
[[nodiscard]] bool isIdentityRamp(std::span<const std::uint16_t> ramp);

} // namespace autostereo::devices
