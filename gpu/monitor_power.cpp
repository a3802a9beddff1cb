#include "gpu/monitor_power.hpp"

#include <xcb/dpms.h>

#include <cstdint>
#include <cstdlib>

namespace autostereo::gpu {

namespace {

struct Free {
    void operator()(void* reply) const { std::free(reply); } // NOLINT(*-no-malloc): xcb's own
};
template<class T>
using Reply = std::unique_ptr<T, Free>;

/// Whether the server did it.
bool done(xcb_connection_t* server, xcb_void_cookie_t cookie) {
    return Reply<xcb_generic_error_t>(xcb_request_check(server, cookie)) == nullptr;
}

bool hasDpms(xcb_connection_t* server) {
    if (xcb_connection_has_error(server) != 0) return false;
    const auto* extension = xcb_get_extension_data(server, &xcb_dpms_id);
    if (extension == nullptr || extension->present == 0) return false;
    const Reply<xcb_dpms_capable_reply_t> capable(
        xcb_dpms_capable_reply(server, xcb_dpms_capable(server), nullptr));
    return capable && capable->capable != 0;
}

} // namespace

/// Seconds without input after which the server turns monitors off, and whether it does.
struct MonitorPower::Times {
    std::uint16_t standby = 0, suspend = 0, off = 0;
    bool enabled = false;
};

void MonitorPower::Disconnect::operator()(xcb_connection_t* server) const {
    xcb_disconnect(server);
}

MonitorPower::MonitorPower() : server_(xcb_connect(nullptr, nullptr)) {
    xcb_connection_t* server = server_.get();
    if (!hasDpms(server)) {
        server_.reset();
        return;
    }
    const Reply<xcb_dpms_get_timeouts_reply_t> times(
        xcb_dpms_get_timeouts_reply(server, xcb_dpms_get_timeouts(server), nullptr));
    const Reply<xcb_dpms_info_reply_t> info(
        xcb_dpms_info_reply(server, xcb_dpms_info(server), nullptr));
    if (!times || !info || !done(server, xcb_dpms_set_timeouts_checked(server, 0, 0, 0)) ||
        !done(server, xcb_dpms_enable_checked(server))) {
        server_.reset();
        return;
    }
    before_ = std::make_unique<Times>(Times{times->standby_timeout, times->suspend_timeout,
                                            times->off_timeout, info->state != 0});
    on_ = false; // nobody knows: who came before may have left them off
    turn(true);
}

MonitorPower::~MonitorPower() {
    if (server_) restore();
}

void MonitorPower::restore() {
    turn(true);
    xcb_connection_t* server = server_.get();
    xcb_dpms_set_timeouts(server, before_->standby, before_->suspend, before_->off);
    if (!before_->enabled) xcb_dpms_disable(server);
    xcb_flush(server);
}

void MonitorPower::turn(bool on) {
    if (!server_ || on == on_) return;
    const std::uint16_t level = on ? XCB_DPMS_DPMS_MODE_ON : XCB_DPMS_DPMS_MODE_OFF;
    if (done(server_.get(), xcb_dpms_force_level_checked(server_.get(), level))) on_ = on;
}

} // namespace autostereo::gpu
