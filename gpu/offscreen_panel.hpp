#pragma once

#include "devices/clock.hpp"
#include "gpu/gl/context.hpp"
#include "gpu/gl/objects.hpp"
#include "gpu/panel.hpp"

namespace autostereo::gpu {

/// A panel without a monitor: surfaceless context and an RGBA8 framebuffer of the asked size.
class OffscreenPanel final : public Panel {
  public:
    /// `refreshHz`: pictures leave at the ticks of a monitor's clock, 0: at once. Throws GlError.
    OffscreenPanel(int width, int height, bool debugContext, double refreshHz = 0);

    [[nodiscard]] int width() const override { return color_.width(); }
    [[nodiscard]] int height() const override { return color_.height(); }
    [[nodiscard]] GLuint framebuffer() const override { return framebuffer_.name(); }
    void present() override;
    void pollEvents() override {}
    [[nodiscard]] bool closed() const override { return false; }
    [[nodiscard]] std::string description() const override { return "off-screen"; }

  private:
    gl::SurfacelessContext context_;
    gl::Texture color_;
    gl::Framebuffer framebuffer_;
    devices::SteadyClock clock_;
    devices::Duration refresh_; ///< 0: none
};

} // namespace autostereo::gpu
