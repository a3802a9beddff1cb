#pragma once

#include "devices/frame.hpp"
#include "devices/pixel_sharing.hpp"
#include "gpu/gl/byte_import.hpp"

#include <cstdint>
#include <map>
#include <memory>

namespace autostereo::gpu {

/// Pictures that the GPU reads where the camera's driver left them. Offers that to cameras that can
/// (DumbMemory of the context's card, else the driver's own memory). The first picture of each set
/// of buffers is compared with what the host sees there, row by row; where the driver reads other
/// bytes, or refuses, the camera is told and what comes next is tried. Thread-bound to the context.
class ColorImport {
  public:
    ColorImport() = default;
    ColorImport(const ColorImport&) = delete;
    ColorImport& operator=(const ColorImport&) = delete;
    ~ColorImport();

    /// A frame's bytes as an R8 texture, as ColorConverter::byteGrid has it; 0: they have to be
    /// uploaded. `wanted`: whether anything else can be done with it than to upload it.
    [[nodiscard]] GLuint bytesOf(const devices::Frame& frame, bool wanted);
    /// What reads them has been given to the GPU; until that is done the driver does not get them
    /// back.
    void readBy(const devices::Frame& frame);
    /// How the newest picture came.
    [[nodiscard]] devices::PixelWay way() const { return way_; }

  private:
    enum class Verdict : std::uint8_t { Unknown, Same, Different };

    [[nodiscard]] GLuint imported(const devices::Frame& frame);
    [[nodiscard]] Verdict compare(GLuint texture, const devices::Frame& frame) const;
    void letGo();

    std::uint64_t set_ = 0;
    std::map<std::uint32_t, gl::ByteImport> imports_; ///< of that set, by the buffer's index
    Verdict verdict_ = Verdict::Unknown;              ///< on that set
    std::shared_ptr<const devices::SharedPixels> held_;
    GLsync fence_ = nullptr;
    devices::PixelWay way_ = devices::PixelWay::Copied;
};

} // namespace autostereo::gpu
