#pragma once

#include "gpu/panel.hpp"

#include <string>
#include <vector>

struct GLFWwindow;

namespace autostereo::gpu {

/// What a window system offers.
struct MonitorInfo {
    std::string name;
    int width = 0; ///< current mode, pixels
    int height = 0;
    int refreshHz = 0;
};

/// Monitors of the current display server; empty where there is none.
[[nodiscard]] std::vector<MonitorInfo> listMonitors();

/// Full screen on one monitor in its current mode, one texel to one pixel. Swaps on vertical sync.
class WindowPanel final : public Panel {
  public:
    /// Takes the first monitor whose mode is width x height; 0 x 0 takes the primary one. With
    /// `force` the primary monitor is taken even if its mode differs. Throws GlError.
    WindowPanel(int width, int height, bool force, bool debugContext);
    ~WindowPanel() override;
    WindowPanel(const WindowPanel&) = delete;
    WindowPanel& operator=(const WindowPanel&) = delete;

    [[nodiscard]] int width() const override { return width_; }
    [[nodiscard]] int height() const override { return height_; }
    [[nodiscard]] GLuint framebuffer() const override { return 0; }
    void present() override;
    void pollEvents() override;
    [[nodiscard]] bool closed() const override;
    [[nodiscard]] std::string description() const override { return description_; }

  private:
    GLFWwindow* window_ = nullptr;
    int width_ = 0;
    int height_ = 0;
    std::string description_;
};

} // namespace autostereo::gpu
