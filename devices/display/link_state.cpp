#include "devices/display/link_state.hpp"

#include <algorithm>
#include <cstdlib>

namespace autostereo::devices {

namespace {

std::string sizeText(const PixelSize& size) {
    return std::to_string(size.width) + "x" + std::to_string(size.height);
}

/// Collects what is wrong.
class Findings {
  public:
    void refuse(bool wrong, const std::string& text) {
        if (wrong) refused_.push_back({LinkProblem::Severity::Refuse, text});
    }
    void warn(bool wrong, const std::string& text) {
        if (wrong) warned_.push_back({LinkProblem::Severity::Warn, text});
    }
    [[nodiscard]] std::vector<LinkProblem> all() const {
        std::vector<LinkProblem> problems = refused_;
        problems.insert(problems.end(), warned_.begin(), warned_.end());
        return problems;
    }

  private:
    std::vector<LinkProblem> refused_;
    std::vector<LinkProblem> warned_;
};

void checkOrientation(const LinkState& link, Findings& found) {
    found.refuse(link.rotationDeg.value_or(0) != 0,
                 "the output is rotated by " + std::to_string(link.rotationDeg.value_or(0)) +
                     " degrees, so sub-pixels do not lie where the lens expects them: turn output "
                     "rotation off");
    found.refuse(link.reflected.value_or(false),
                 "the output is mirrored, so every view goes to the wrong place: turn output "
                 "reflection off");
}

void checkSize(const LinkState& link, Findings& found) {
    found.refuse(link.interlaced.value_or(false),
                 "the output's mode is interlaced, so rows of two pictures mix: set a progressive "
                 "mode");
    if (link.source && link.shown)
        found.refuse(*link.source != *link.shown,
                     "the graphics card scales " + sizeText(*link.source) + " to " +
                         sizeText(*link.shown) +
                         ", so views mix: set the display server's scale to 1");
    constexpr int kWidestInEdid = 4095; // a wider panel's preferred timing is not its native one
    if (link.mode && link.native && link.mode->width <= kWidestInEdid)
        found.refuse(*link.mode != *link.native,
                     "the output's mode is " + sizeText(*link.mode) +
                         " but the monitor's native one is " + sizeText(*link.native) +
                         ", so something scales and views mix: set the native mode");
    found.warn(!link.native && (link.modeScaling == ModeScaling::Full ||
                                link.modeScaling == ModeScaling::FullAspect),
               "the graphics card scales every mode to the panel's size, which the monitor does "
               "not tell: set scaling mode to None");
    if (link.shown && link.mode)
        found.refuse(link.source == link.shown && *link.shown != *link.mode,
                     "the picture of " + sizeText(*link.shown) +
                         " does not fill the output's mode of " + sizeText(*link.mode) +
                         ": let it cover the whole output");
}

void checkBorders(const LinkState& link, Findings& found) {
    const PixelSize border = link.border.value_or(PixelSize{});
    found.refuse(border.width != 0 || border.height != 0,
                 "the graphics card shrinks the picture by a border of " + sizeText(border) +
                     " pixels against overscan, so views mix: turn underscan off and set margins "
                     "to 0");
    found.warn(link.monitorOverscans.value_or(false),
               "the monitor may enlarge the picture and cut its edges off (overscan): set its "
               "picture size to 1:1, just scan or PC in its own menu");
}

void checkFormat(const LinkState& link, Findings& found) {
    const auto is = [&](ColorFormat format) { return link.colorFormat == format; };
    for (const auto& [format, name] :
         {std::pair(ColorFormat::Ycbcr422, "4:2:2"), std::pair(ColorFormat::Ycbcr420, "4:2:0")})
        found.refuse(is(format), std::string("the link carries YCbCr ") + name +
                                     ", which shares colour between neighbouring pixels and so "
                                     "mixes views: set the output to RGB");
    found.warn(is(ColorFormat::Ycbcr444),
               "the link carries YCbCr 4:4:4, which rounds sub-pixels into each other a little: "
               "set the output to RGB");
    const std::string space = link.colorSpace.value_or("Default");
    found.warn(space != "Default",
               "the output declares colour space " + space +
                   ", so the monitor mixes channels when it converts: set Colorspace to Default");
}

void checkRange(const LinkState& link, Findings& found) {
    found.warn(link.range == ColorRange::Limited,
               "the output squeezes RGB into the limited range 16 to 235, so contrast between "
               "views is lost: set Broadcast RGB to Full");
    found.warn(link.range == ColorRange::Automatic && link.rangeSelectable == false,
               "the output chooses the RGB range by itself and this monitor does not say that it "
               "follows: set Broadcast RGB to Full, and the monitor's black level or HDMI range "
               "to full or normal");
}

void checkCurves(const LinkState& link, Findings& found) {
    found.refuse(link.colorMatrix == ColorMatrix::Mixing,
                 "a colour matrix mixes red, green and blue, and with them views: turn off colour "
                 "correction, saturation and HDR conversion of the display server");
    found.warn(link.colorMatrix == ColorMatrix::Scaling,
               "a colour matrix scales the channels, so views differ in brightness: turn off "
               "night light and colour correction");
    found.warn(link.gammaIsIdentity == false,
               "the gamma ramp is not identity, so views differ in colour and brightness: turn "
               "off night light (redshift) and unload the colour profile");
    found.warn(link.degammaIsIdentity == false,
               "a degamma table is loaded, so levels are not shown as drawn: turn off the display "
               "server's colour management");
    found.warn(
        link.hdr.value_or(false),
        "the output is in HDR, so the monitor applies a tone curve of its own: turn HDR off");
}

void checkDepth(const LinkState& link, Findings& found) {
    if (link.maxBitsPerChannel)
        found.warn(*link.maxBitsPerChannel < 8,
                   "the link carries at most " + std::to_string(*link.maxBitsPerChannel) +
                       " bits per channel: set max bpc to 8 or more, or a lower refresh rate");
    found.warn(link.dithering.value_or(false),
               "the graphics card dithers, which puts noise into single sub-pixels: turn "
               "dithering off");
    found.warn(link.linkGood == false,
               "the link to the monitor failed its training: use a shorter or better cable");
}

} // namespace

std::vector<LinkProblem> linkProblems(const LinkState& link) {
    Findings found;
    checkOrientation(link, found);
    checkSize(link, found);
    checkBorders(link, found);
    checkFormat(link, found);
    checkRange(link, found);
    checkCurves(link, found);
    checkDepth(link, found);
    return found.all();
}

void addMonitor(const Edid& edid, LinkState& link) {
    if (edid.nativeWidth > 0 && !edid.interlaced)
        link.native = PixelSize{edid.nativeWidth, edid.nativeHeight};
    // Without HDMI a monitor takes PC timings, whole and in full range, whatever it is sent.
    link.monitorOverscans = edid.hdmi && (edid.alwaysOverscans || !edid.underscans);
    link.rangeSelectable = !edid.hdmi || edid.quantisationSelectable;
}

bool isIdentityRamp(std::span<const std::uint16_t> ramp) {
    if (ramp.empty()) return true;
    if (ramp.size() < 2) return false;
    // A step of 8 bits: drivers write 255 as 65535 or as 65280.
    constexpr double kTolerance = 65535.0 / 255;
    for (std::size_t i = 0; i < ramp.size(); ++i) {
        const double identity =
            65535.0 * static_cast<double>(i) / static_cast<double>(ramp.size() - 1);
        if (std::abs(ramp[i] - identity) > kTolerance) return false;
    }
    return true;
}

} // namespace autostereo::devices
