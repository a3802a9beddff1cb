#include "daemon/commands/rig_quality.hpp"

#include "calib/solve/opencv_yaml.hpp"
#include "config/units.hpp"
#include "devices/replay/whole_file.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>

namespace autostereo::daemon {

namespace {

double largest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

nlohmann::ordered_json toJson(const config::RigFile& file) {
    nlohmann::ordered_json json;
    for (const config::QualityKey& entry : config::qualityKeys())
        if (const auto found = file.quality.find(std::string(entry.key));
            found != file.quality.end())
            json[std::string(entry.key)] = found->second;
    if (file.colorLateS != 0) json["color_late_ms"] = config::units::msFromSeconds(file.colorLateS);
    json["warnings"] = file.warnings;
    return json;
}

} // namespace

void requireRigFile(const BoardOptions& options) {
    if (options.output.extension() != ".toml")
        throw UsageError("--output: " + options.output.string() +
                         " is no rig file (allowed *.toml)");
}

void addCamera(config::RigFile& file, const char* prefix,
               const calibrate::CameraCalibration& found) {
    const std::string key = std::string(prefix) + '_';
    file.quality[key + "views"] = static_cast<double>(
        std::ranges::count(found.views, false, &calibrate::ViewScore::rejected));
    file.quality[key + "rms_px"] = found.rmsPx;
    file.quality[key + "left_out_px"] = found.heldOutPx;
    file.quality[key + "focal_95_px"] = found.half95[0];
    file.quality[key + "condition"] = found.condition;
    const std::string which = key == "depth_" ? "depth camera: " : "colour camera: ";
    for (const std::string& warning : found.warnings)
        file.warnings.push_back(which + warning);
    for (const calibrate::ViewScore& view : found.views)
        if (view.rejected) file.warnings.push_back(which + view.name + " rejected");
    (key == "depth_" ? file.depth : file.color) = found.camera;
}

void addRig(config::RigFile& file, const calibrate::RigCalibration& found) {
    addCamera(file, "depth", found.depth);
    addCamera(file, "color", found.color);
    file.colorFromDepth = found.colorFromDepth;
    file.quality["pairs"] = static_cast<double>(
        std::ranges::count(found.pairs, false, &calibrate::ViewScore::rejected));
    file.quality["separate_rms_px"] = found.separateRmsPx;
    file.quality["rms_px"] = found.jointRmsPx;
    file.quality["rotation_95_deg"] = config::units::degFromRadians(largest(found.turn95Rad));
    file.quality["translation_95_mm"] = config::units::mmFromMetres(largest(found.shift95M));
    for (const calibrate::RegistrationError& error : found.registration)
        file.quality["registration_95_mm_at_" +
                     std::to_string(std::lround(config::units::mmFromMetres(error.rangeM))) +
                     "_mm"] = error.mm95;
    for (const calibrate::ViewScore& pair : found.pairs)
        if (pair.rejected) file.warnings.push_back("both cameras: " + pair.name + " rejected");
}

void addDepthBias(config::RigFile& file, const FoundBoards& found, const calibrate::Board& board) {
    std::vector<calibrate::DepthBoard> boards;
    for (std::size_t i = 0; i < found.depthPictures.size(); ++i)
        boards.push_back({&found.views.depth[i], &found.depthPictures[i]});
    const auto bias = calibrate::depthBias(*file.depth, board, boards);
    if (!bias) return;
    file.quality["depth_bias_mm"] = config::units::mmFromMetres(bias->atOneMetreM);
    file.quality["depth_bias_95_mm"] = config::units::mmFromMetres(bias->at95M);
    file.quality["depth_bias_mm_per_m"] = config::units::mmFromMetres(bias->perMetreM);
    file.quality["depth_bias_dark_mm"] = config::units::mmFromMetres(bias->darkM);
}

void printCamera(const char* which, const calibrate::CameraCalibration& found) {
    std::printf("%s: %s\n", which, calibrate::nameOf(found.lens).data());
    for (const calibrate::ModelTrial& trial : found.trials)
        std::printf("  %-22s %6.3f px rms, %6.3f px left out, focal length %7.1f +- %.1f px\n",
                    calibrate::nameOf(trial.lens).data(), trial.rmsPx, trial.heldOutPx,
                    trial.focalPx, trial.focal95Px);
    for (const calibrate::ViewScore& view : found.views)
        std::printf("  %-22s %6.3f px%s\n", view.name.c_str(), view.rmsPx,
                    view.rejected ? " rejected" : "");
    std::fflush(stdout);
}

void deliver(const config::RigFile& file, const BoardOptions& options) {
    devices::replaceKeepingOld(options.output, config::rigText(file), "calibrate: ");
    if (options.opencv)
        devices::writeWhole(*options.opencv,
                            calibrate::openCvYaml(file.depth, file.color, file.colorFromDepth),
                            "calibrate: ");
    if (options.json) {
        std::cout << toJson(file).dump(2) << '\n';
        return;
    }
    for (const std::string& line : config::explained(file))
        std::cout << line << '\n';
    std::cout << options.output.string() << " written\n";
}

} // namespace autostereo::daemon
