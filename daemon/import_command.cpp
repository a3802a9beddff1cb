#include "config/text_file.hpp"
#include "config/vendor_calibration.hpp"
#include "daemon/command_words.hpp"
#include "daemon/commands.hpp"
#include "daemon/wiring.hpp"
#include "devices/replay/whole_file.hpp"

#include <iostream>

namespace autostereo::daemon {

namespace {

const std::map<std::string, config::Vendor> kVendors{
    {"looking-glass", config::Vendor::LookingGlass}, {"cubevi", config::Vendor::Cubevi}};
constexpr std::array kLaterKinds{"k4a", "kinect2", "opencv", "ros"};

config::Vendor vendorOf(const std::string& kind) {
    if (contains(kLaterKinds, kind)) notInThisVersion("import: " + kind);
    std::optional<config::Vendor> vendor;
    oneOf(vendor, kVendors, "import")(kind);
    return *vendor;
}

} // namespace

int importCalibration(const ImportOptions& options) {
    const config::Vendor vendor = vendorOf(options.kind);
    if (options.output.extension() != ".toml")
        throw UsageError("--output: " + options.output.string() +
                         " is no display file (allowed "
                         "*.toml)");
    const config::ImportedDisplay imported =
        config::importDisplay(vendor, options.file.string(), config::readTextFile(options.file),
                              {options.base, options.order});
    // Nothing is written that would not load.
    const auto display = config::displayFromText(options.output.string(), imported.toml);
    devices::writeWhole(options.output, imported.toml, "import: ");
    for (const std::string& warning : imported.warnings)
        std::cerr << options.file.string() << ": warning: " << warning << '\n';
    std::cout << options.output.string() << ": " << display.model << " (built on " << imported.base
              << ")\n";
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
