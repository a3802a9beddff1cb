#pragma once

#include "gpu/gl/api.hpp"
#include "gpu/key_press.hpp"

#include <string>
#include <vector>

namespace autostereo::gpu {

/// Where pixels go: a full-screen window or an off-screen picture. Owns the GL context, which is
/// current on the constructing thread for the panel's life; everything GL is thread-bound to it.
class Panel {
  public:
    virtual ~Panel() = default;
    [[nodiscard]] virtual int width() const = 0; ///< pixels, unscaled
    [[nodiscard]] virtual int height() const = 0;
    [[nodiscard]] virtual GLuint framebuffer() const = 0;
    /// Returns when the picture is out, as far as the driver tells: nothing is queued. Throws
    /// PanelLost.
    virtual void present() = 0;
    /// Throws PanelLost.
    virtual void pollEvents() = 0;
    /// Pressed since the last call, as far as `pollEvents` has seen; none without a keyboard.
    [[nodiscard]] virtual std::vector<KeyPress> takeKeys() { return {}; }
    [[nodiscard]] virtual bool closed() const = 0;
    /// Power of the monitor; nothing where it cannot be turned off. Returns when it is done.
    virtual void turnMonitor(bool /*on*/) {}
    [[nodiscard]] virtual bool monitorIsOn() const { return true; }
    [[nodiscard]] virtual std::string description() const = 0;
};

/// GL_RENDERER of the current context.
[[nodiscard]] std::string rendererName();

} // namespace autostereo::gpu
