#pragma once

#include "gpu/monitor_choice.hpp"
#include "gpu/monitor_power.hpp"
#include "gpu/panel.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

struct GLFWwindow;

namespace autostereo::gpu {

/// Monitors of the current display server, the primary one first; empty where there is none.
[[nodiscard]] std::vector<MonitorInfo> listMonitors();

/// What the display server sends each channel's levels through, 0 to 65535; all of one size.
struct GammaRamp {
    std::vector<std::uint16_t> red;
    std::vector<std::uint16_t> green;
    std::vector<std::uint16_t> blue;
};

/// Full screen on one monitor in its current mode, one texel to one pixel. Swaps on vertical sync.
class WindowPanel final : public Panel {
  public:
    /// Takes the monitor that `chooseMonitor` says. The pointer is hidden, the screen saver does
    /// not come while the window is there. Throws GlError.
    WindowPanel(const MonitorRequest& request, bool debugContext);
    ~WindowPanel() override;
    WindowPanel(const WindowPanel&) = delete;
    WindowPanel& operator=(const WindowPanel&) = delete;

    [[nodiscard]] int width() const override { return width_; }
    [[nodiscard]] int height() const override { return height_; }
    [[nodiscard]] GLuint framebuffer() const override { return 0; }
    void present() override;
    void pollEvents() override;
    [[nodiscard]] std::vector<KeyPress> takeKeys() override;
    [[nodiscard]] bool closed() const override;
    void turnMonitor(bool on) override;
    [[nodiscard]] bool monitorIsOn() const override { return power_.isOn(); }
    [[nodiscard]] std::string description() const override { return description_; }

    /// Nothing where the display server does not tell (Wayland, Xvfb).
    [[nodiscard]] std::optional<GammaRamp> gammaRamp() const;

  private:
    void checkMonitor() const;

    GLFWwindow* window_ = nullptr;
    MonitorInfo monitor_; ///< as it was when the window opened
    std::chrono::steady_clock::time_point checkedAt_;
    int width_ = 0;
    int height_ = 0;
    std::string description_;
    std::vector<KeyPress> keys_;
    MonitorPower power_;
    bool saidCannot_ = false; ///< that it cannot be turned off
};

} // namespace autostereo::gpu
