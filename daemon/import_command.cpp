#include "config/text_file.hpp"
#include "config/vendor_calibration.hpp"
#include "daemon/command_words.hpp"
#include "daemon/commands.hpp"
#include "daemon/wiring.hpp"

#include <fstream>
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

/// Under a temporary name first: a file that is there is the whole one.
void write(const std::filesystem::path& file, const std::string& text) {
    std::filesystem::path temporary = file;
    temporary += ".part";
    std::ofstream out(temporary, std::ios::binary);
    out << text;
    out.close();
    std::error_code error;
    if (out) std::filesystem::rename(temporary, file, error);
    if (!out || error) {
        std::error_code ignored;
        std::filesystem::remove(temporary, ignored);
        throw std::runtime_error(
            "import: cannot write " + file.string() + ": " +
            (error ? error : std::error_code(errno, std::generic_category())).message());
    }
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
    write(options.output, imported.toml);
    for (const std::string& warning : imported.warnings)
        std::cerr << options.file.string() << ": warning: " << warning << '\n';
    std::cout << options.output.string() << ": " << display.model << " (built on " << imported.base
              << ")\n";
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
