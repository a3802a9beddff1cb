#pragma once

#include "calib/display_profile.hpp"
#include "gpu/gl/objects.hpp"

namespace autostereo::gpu {

/// Where the views lie in the atlas: view 0 bottom left (texel 0, 0), rows left to right, bottom to
/// top, as quilts have it.
struct AtlasLayout {
    int views = 1;
    calib::QuiltLayout quilt;

    [[nodiscard]] int width() const { return quilt.columns * quilt.tileWidth; }
    [[nodiscard]] int height() const { return quilt.rows * quilt.tileHeight; }
    [[nodiscard]] int left(int view) const { return view % quilt.columns * quilt.tileWidth; }
    [[nodiscard]] int bottom(int view) const { return view / quilt.columns * quilt.tileHeight; }
};

/// The profile's tiles; a profile without a fixed mode gets tiles of the panel's size.
[[nodiscard]] AtlasLayout atlasLayout(const calib::DisplayProfile& display, int panelWidth,
                                      int panelHeight);

/// Tiles `scale` times as large each way.
[[nodiscard]] AtlasLayout scaled(AtlasLayout layout, double scale);

/// All views in one picture, with one depth buffer (de Sorbier 2010). Thread-bound.
class Atlas {
  public:
    /// Throws GlError where the driver does not allow the size.
    explicit Atlas(const AtlasLayout& layout);
    [[nodiscard]] const AtlasLayout& layout() const { return layout_; }
    [[nodiscard]] const gl::Texture& color() const { return color_; }
    [[nodiscard]] const gl::Texture& depth() const { return depth_; }
    [[nodiscard]] GLuint framebuffer() const { return framebuffer_.name(); }

  private:
    AtlasLayout layout_;
    gl::Texture color_;
    gl::Texture depth_;
    gl::Framebuffer framebuffer_;
};

} // namespace autostereo::gpu
