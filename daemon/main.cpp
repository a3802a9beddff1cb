#include "config/load.hpp"
#include "daemon/commands/commands.hpp"
#include "daemon/control/control_socket.hpp"
#include "devices/input.hpp"
#include "gpu/gl/error.hpp"

#include <cstdlib>
#include <exception>
#include <iostream>

namespace {

using namespace autostereo; // NOLINT(google-build-using-namespace): the program's own entry

template<class... Handlers>
struct Overloaded : Handlers... {
    using Handlers::operator()...;
};
template<class... Handlers>
Overloaded(Handlers...) -> Overloaded<Handlers...>;

int perform(const daemon::CommandLine& command) {
    return std::visit(
        Overloaded{
            [](const daemon::RunOptions& options) { return daemon::run(options); },
            [](const daemon::RecordOptions& options) { return daemon::record(options); },
            [](const daemon::RenderOptions& options) { return daemon::render(options); },
            [](const daemon::CheckOptions& options) { return daemon::check(options); },
            [](const daemon::DevicesOptions& options) { return daemon::listDevices(options); },
            [](const daemon::InterleaveOptions& options) { return daemon::interleave(options); },
            [](const daemon::ViewmapOptions& options) { return daemon::viewmap(options); },
            [](const daemon::LookOptions& options) { return daemon::look(options); },
            [](const daemon::PatternOptions& options) { return daemon::pattern(options); },
            [](const daemon::BenchOptions& options) { return daemon::benchmark(options); },
            [](const daemon::ImportOptions& options) { return daemon::importCalibration(options); },
            [](const daemon::LatencyOptions& options) { return daemon::measureLatency(options); },
            [](const daemon::ControlOptions& options) { return daemon::control(options); },
            [](const daemon::CalibrateNoiseOptions& options) {
                return daemon::calibrateNoise(options);
            },
            [](const daemon::CalibrateCamerasOptions& options) {
                return daemon::calibrateCameras(options);
            },
            [](const daemon::CalibrateRigOptions& options) {
                return daemon::calibrateRig(options);
            },
            [](const daemon::CalibrateTimingOptions& options) {
                return daemon::calibrateTiming(options);
            },
            [](const daemon::CalibrateDisplayOptions& options) {
                return daemon::calibrateDisplay(options);
            },
            [](const daemon::Information& information) {
                std::cout << information.text;
                return EXIT_SUCCESS;
            }},
        command);
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
    if (const auto* control = dynamic_cast<const daemon::ControlError*>(&error))
        return control->nobodyThere() ? NotFound : FailedRunning;
    return FailedRunning;
}

} // namespace

int main(int argc, char** argv) try {
    return perform(daemon::parseCommandLine(argc, argv));
} catch (const std::exception& error) {
    std::cerr << "autostereo: " << error.what() << '\n';
    return exitCodeOf(error);
}
