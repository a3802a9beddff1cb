#pragma once

#include "devices/clock.hpp"
#include "devices/frame.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace autostereo::devices::v4l2 {

/// What a camera is taken for.
enum class Role : std::uint8_t { Color, Depth };

/// Four letters, as the kernel's headers have them.
using FourCc = std::uint32_t;
[[nodiscard]] std::string text(FourCc code);

/// A format that we can show: what becomes of it.
struct KnownFormat {
    FourCc code = 0;
    Role role = Role::Color;
    PixelFormat pixels = PixelFormat::Rgba8;
    bool jpeg = false; ///< has to be decoded, to `pixels`
};
[[nodiscard]] std::span<const KnownFormat> knownFormats();
/// Nothing: a format that we cannot show.
[[nodiscard]] const KnownFormat* knownFormat(FourCc code);

/// One way in which a camera can be run.
struct Mode {
    FourCc code = 0;
    int width = 0;
    int height = 0;
    Duration period{0}; ///< between frames, 0: the camera does not say

    [[nodiscard]] bool operator==(const Mode&) const = default;
};
[[nodiscard]] std::string text(const Mode& mode);

/// What is asked of a camera; unset: the camera's best for the purpose.
struct ModeRequest {
    Role role = Role::Color;
    std::optional<FourCc> code;
    std::optional<int> width, height;
    double framesPerSecond = 30;
};

/// The offered mode that fits best: of the formats and sizes that are allowed one that reaches the
/// frame rate before one that does not, then the size nearest to the wanted one (1280x720 unless
/// said; depth: the largest), then uncompressed before JPEG, colour before grey. Nothing: none
/// fits.
[[nodiscard]] std::optional<Mode> chooseMode(std::span<const Mode> offered,
                                             const ModeRequest& request);

/// How Y, Cb and Cr are meant, from what the driver says in V4L2's numbers (0: default).
struct YuvMeaning {
    YuvMatrix matrix = YuvMatrix::Auto;
    YuvRange range = YuvRange::Auto;
};
[[nodiscard]] YuvMeaning yuvMeaning(std::uint32_t colorspace, std::uint32_t encoding,
                                    std::uint32_t quantization);

} // namespace autostereo::devices::v4l2
