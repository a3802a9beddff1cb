#include "calib/solve/camera_file.hpp"
#include "calib/solve/refusal.hpp"
#include "config/load.hpp"
#include "config/rig_file.hpp"
#include "config/text_file.hpp"
#include "config/vendor_calibration.hpp"
#include "daemon/command_words.hpp"
#include "daemon/commands/commands.hpp"
#include "daemon/wiring.hpp"
#include "devices/kinect2/parameters_file.hpp"
#include "devices/kinect2/registration.hpp"
#include "devices/replay/calibration_files.hpp"
#include "devices/replay/whole_file.hpp"

#include <cstdio>
#include <iostream>
#include <span>

namespace autostereo::daemon {

namespace {

const std::map<std::string, config::Vendor> kVendors{
    {"looking-glass", config::Vendor::LookingGlass}, {"cubevi", config::Vendor::Cubevi}};

config::Vendor vendorOf(const std::string& kind) {
    const auto found = kVendors.find(kind);
    if (found == kVendors.end())
        throw UsageError(
            "import: " + kind +
            " is not known (allowed cubevi, k4a, kinect2, looking-glass, opencv, ros)");
    return found->second;
}

/// Rows and columns of "640x576".
std::optional<calibrate::PictureSize> sizeOf(const std::optional<std::string>& text,
                                             const char* option) {
    if (!text) return std::nullopt;
    calibrate::PictureSize size;
    char rest = 0;
    if (std::sscanf(text->c_str(), "%5dx%5d%c", &size.width, &size.height, &rest) != 2 ||
        size.width < 1 || size.height < 1)
        throw UsageError(std::string(option) + ": " + *text + " is no size (allowed e.g. 640x576)");
    return size;
}

config::RigFile factoryRig(const ImportOptions& options) {
    const auto depth =
        sizeOf(options.depthSize, "--depth-size").value_or(calibrate::PictureSize{640, 576});
    const auto color =
        sizeOf(options.colorSize, "--color-size").value_or(calibrate::PictureSize{1280, 720});
    const std::string text = config::readTextFile(options.file);
    try {
        const calib::SensorRig rig = devices::readKinectCalibration(
            std::as_bytes(std::span(text)), options.file.string(), {depth.width, depth.height},
            {color.width, color.height});
        return {rig.depth, rig.color, rig.colorFromDepth, rig.provenance, {}, {}};
    } catch (const devices::DeviceError& error) {
        throw config::ConfigError(error.what());
    }
}

config::RigFile kinect2Rig(const ImportOptions& options) {
    const std::string name = options.file.string();
    try {
        const auto unit =
            devices::kinect2::readParameters(config::readTextFile(options.file), name);
        const auto [rig, rmsPx, worstPx] = devices::kinect2::fitRig(unit.color, unit.depth);
        constexpr double kMostPx = 2; // real units fit to a tenth
        if (!(worstPx <= kMostPx))
            throw config::ConfigError(name +
                                      ": color: no lens does what its polynomials say (off "
                                      "by up to " +
                                      std::to_string(worstPx) + " px, allowed 2)");
        return {rig.depth,
                rig.color,
                rig.colorFromDepth,
                "imported from " + options.file.filename().string(),
                {},
                {}};
    } catch (const devices::DeviceError& error) {
        throw config::ConfigError(error.what());
    }
}

/// The depth camera's file, or one of both; the colour camera's and the transform's, if apart.
config::RigFile otherProgramsRig(const ImportOptions& options) {
    const double unitM = options.millimetres ? 1e-3 : 1;
    const auto read = [&](const std::filesystem::path& file,
                          const std::optional<calibrate::PictureSize>& size) {
        try {
            return calibrate::readCameraFile(config::readTextFile(file), file.string(),
                                             size.value_or(calibrate::PictureSize{}), unitM);
        } catch (const calibrate::Refusal& refusal) {
            throw config::ConfigError(refusal.what());
        }
    };
    const calibrate::CameraFile main =
        read(options.file, sizeOf(options.depthSize, "--depth-size"));
    config::RigFile rig{main.first, main.second, main.secondFromFirst, {}, {}, {}};
    rig.provenance = "imported from " + options.file.filename().string();
    if (options.color) {
        rig.color = read(*options.color, sizeOf(options.colorSize, "--color-size")).first;
        rig.provenance += ", " + options.color->filename().string();
    }
    if (options.pose) {
        rig.colorFromDepth = read(*options.pose, std::nullopt).secondFromFirst;
        rig.provenance += ", " + options.pose->filename().string();
    }
    return rig;
}

int importRig(const ImportOptions& options) {
    if (options.output.extension() != ".toml")
        throw UsageError("--output: " + options.output.string() +
                         " is no rig file (allowed *.toml)");
    const config::RigFile rig = options.kind == "k4a"       ? factoryRig(options)
                                : options.kind == "kinect2" ? kinect2Rig(options)
                                                            : otherProgramsRig(options);
    devices::replaceKeepingOld(options.output, config::rigText(rig), "import: ");
    for (const std::string& line : config::explained(rig))
        std::cout << line << '\n';
    return EXIT_SUCCESS;
}

} // namespace

int importCalibration(const ImportOptions& options) {
    constexpr std::array kCameras{"k4a", "kinect2", "opencv", "ros"};
    if (contains(kCameras, options.kind)) return importRig(options);
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
