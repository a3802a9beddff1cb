#pragma once

#include <memory>

struct xcb_connection_t;

namespace autostereo::gpu {

/// The monitors' power over the X server's DPMS extension (Display Power Management Signaling).
/// While this lives, only what is said here turns them off: a server left alone does so after ten
/// minutes without a keyboard's key. Does nothing where no X server with the extension is reached
/// (Wayland, Xvfb). Thread-bound.
class MonitorPower {
  public:
    MonitorPower();
    /// On again, and the server's times as they were.
    ~MonitorPower();
    MonitorPower(const MonitorPower&) = delete;
    MonitorPower& operator=(const MonitorPower&) = delete;

    [[nodiscard]] bool canTurnOff() const { return server_ != nullptr; }
    /// Where nothing can be turned off they are on.
    [[nodiscard]] bool isOn() const { return on_; }
    /// Returns when the server has done it.
    void turn(bool on);

  private:
    struct Times;
    void restore();

    struct Disconnect {
        void operator()(xcb_connection_t* server) const;
    };
    std::unique_ptr<xcb_connection_t, Disconnect> server_;
    std::unique_ptr<Times> before_;
    bool on_ = true;
};

} // namespace autostereo::gpu
