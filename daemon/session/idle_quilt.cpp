#include "daemon/session/idle_quilt.hpp"

namespace autostereo::daemon {

void IdleQuilt::draw(double /*seconds*/, const StandingTarget& target) {
    drawQuilt(quilt_, displayFor(quilt_, target.display), target.width, target.height, {},
              target.framebuffer);
}

} // namespace autostereo::daemon
