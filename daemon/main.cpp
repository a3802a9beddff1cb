#include "config/load.hpp"
#include "daemon/commands.hpp"
#include "devices/input.hpp"
#include "gpu/gl/error.hpp"

#include <cstdlib>
#include <exception>
#include <iostream>

namespace {

using namespace autostereo; // NOLINT(google-build-using-namespace): the program's own entry

int perform(const daemon::CommandLine& command) {
    if (const auto* run = std::get_if<daemon::RunOptions>(&command)) return daemon::run(*run);
    if (const auto* render = std::get_if<daemon::RenderOptions>(&command))
        return daemon::render(*render);
    if (const auto* check = std::get_if<daemon::CheckOptions>(&command))
        return daemon::check(*check);
    if (const auto* devices = std::get_if<daemon::DevicesOptions>(&command))
        return daemon::listDevices(*devices);
    std::cout << std::get<daemon::Information>(command).text;
    return EXIT_SUCCESS;
}

enum ExitCode { FailedRunning = 1, BadCommandLineOrConfig = 2, NotFound = 3 };

int exitCodeOf(const std::exception& error) {
    if (dynamic_cast<const daemon::UsageError*>(&error) != nullptr ||
        dynamic_cast<const config::ConfigError*>(&error) != nullptr ||
        dynamic_cast<const devices::AddressError*>(&error) != nullptr)
        return BadCommandLineOrConfig;
    if (const auto* device = dynamic_cast<const devices::DeviceError*>(&error))
        return device->notFound() ? NotFound : FailedRunning;
    if (dynamic_cast<const gpu::DisplayNotFound*>(&error) != nullptr) return NotFound;
    return FailedRunning;
}

} // namespace

int main(int argc, char** argv) try {
    return perform(daemon::parseCommandLine(argc, argv));
} catch (const std::exception& error) {
    std::cerr << "autostereo: " << error.what() << '\n';
    return exitCodeOf(error);
}
