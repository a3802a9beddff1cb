#pragma once

#include "devices/frame.hpp"
#include "gpu/color_converter.hpp"
#include "gpu/color_hold.hpp"
#include "gpu/color_import.hpp"
#include "gpu/dirty/block_marks.hpp"
#include "gpu/gl/objects.hpp"

#include <array>

namespace autostereo::gpu {

/// Frames -> textures, through a ring of persistently mapped buffers, so that the copy to the GPU
/// never waits for the frame before. depth, amplitude: R16UI counts; color: RGBA8, linear filter,
/// converted on the GPU from whatever format it has; where camera and driver can, and noise need
/// not be held on the host, from where the camera's driver left it, without a copy.
/// Textures follow the frames' size. Thread-bound.
class FrameUploader {
  public:
    explicit FrameUploader(const ColorHoldParams& color = {})
        : imports_(color.sigma == 0), hold_(color) {}

    void upload(const devices::RgbdFrame& frame);
    [[nodiscard]] const gl::Texture& depth() const { return depth_; }
    /// None where the newest frame has none.
    [[nodiscard]] const gl::Texture* amplitude() const {
        return hasAmplitude_ ? &amplitude_ : nullptr;
    }
    [[nodiscard]] const gl::Texture& color() const { return color_; }
    /// Whether any of it is another colour than before, and where, in blocks of the picture.
    [[nodiscard]] bool colorChanged() const { return colorChanged_; }
    [[nodiscard]] const BlockMarks& colorMarks() const { return colorMarks_; }
    [[nodiscard]] const ColorHold& hold() const { return hold_; }
    /// How the newest colour frame came.
    [[nodiscard]] devices::PixelWay colorWay() const { return import_.way(); }

  private:
    void uploadColor(const devices::Frame& frame);
    [[nodiscard]] bool importColor(const devices::Frame& frame);
    void fitColor(const devices::FrameMetadata& form);
    void uploadMarks(const devices::FrameMetadata& form);

    /// A mapped staging buffer and the fence behind its last copy.
    class Staging {
      public:
        Staging() = default;
        ~Staging();
        Staging(const Staging&) = delete;
        Staging& operator=(const Staging&) = delete;
        void copy(std::span<const std::byte> pixels, const gl::Texture& to, GLenum format,
                  GLenum type);

      private:
        void reserve(std::size_t bytes);

        gl::Buffer buffer_;
        std::byte* mapped_ = nullptr;
        std::size_t capacity_ = 0;
        GLsync fence_ = nullptr;
    };

    static constexpr std::size_t kRing = 3;
    static constexpr std::size_t kPlanes = 3; // depth, amplitude, colour
    std::array<Staging, kPlanes * kRing> ring_;
    std::size_t next_ = 0;
    bool hasAmplitude_ = false;
    gl::Texture depth_;
    gl::Texture amplitude_;
    gl::Texture color_;
    ColorConverter converter_;
    bool imports_; ///< whether imported pictures are of use
    ColorImport import_;
    ColorHold hold_;
    bool colorChanged_ = false;
    BlockMarks colorMarks_;
    gl::Texture colorBytes_; ///< R8, where the camera's format is converted
};

} // namespace autostereo::gpu
