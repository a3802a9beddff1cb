#include "daemon/session/idle_picture.hpp"

#include "config/read_picture.hpp"
#include "daemon/session/message_panel.hpp"

namespace autostereo::daemon {

IdlePicture::IdlePicture(const std::filesystem::path& file) : picture_(config::readPicture(file)) {}

void IdlePicture::draw(double /*seconds*/, const StandingTarget& target) {
    drawMessage(picture_, "", target);
}

} // namespace autostereo::daemon
