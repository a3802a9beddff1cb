// usage: plugged_kinect2 FPS
// Plugs in a Kinect v2 until it is told to stop (SIGTERM).
#include "tests/device/tof/stairs_show.hpp"
#include "tests/device/usbip/plug.hpp"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>

int main(int argumentCount, char** arguments) {
    using namespace autostereo::test;
    if (argumentCount != 2) {
        std::fprintf(stderr, "usage: %s FPS\n", arguments[0]);
        return 2;
    }
    sigset_t stops;
    sigemptyset(&stops);
    sigaddset(&stops, SIGTERM);
    sigprocmask(SIG_BLOCK, &stops, nullptr); // before there are threads
    try {
        Kinect2Camera camera(stairsShow(std::atof(arguments[1])));
        const usbip::Plug plug(camera, usbip::Speed::Super);
        int signal = 0;
        sigwait(&stops, &signal);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
    return 0;
}
