#include "config/read_viewer.hpp"

#include "config/durations.hpp"
#include "config/load.hpp"
#include "config/rig_file.hpp"
#include "config/units.hpp"

#include <string_view>

namespace autostereo::config {

namespace {

glm::dvec3 vector(TomlReader& table, const char* key, Range range, const glm::dvec3& fallback) {
    const auto found = table.numbers<3>(key, range, std::array{fallback.x, fallback.y, fallback.z});
    return {found[0], found[1], found[2]};
}

void readPose(TomlReader& table, devices::TrackerPose& pose) {
    constexpr Range kPlace{-10000, 10000}, kAngle{-360, 360}, kScale{-10, 10};
    if (table.has("origin_mm")) {
        const auto origin = table.numberList("origin_mm", {0, 3}, kPlace);
        if (origin.size() == 1 || origin.size() == 2)
            table.reject("origin_mm", "is no place (allowed [] or [x, y, z])");
        pose.originM = std::nullopt;
        if (origin.size() == 3)
            pose.originM =
                glm::dvec3{units::metresFromMm(origin[0]), units::metresFromMm(origin[1]),
                           units::metresFromMm(origin[2])};
    }
    const glm::dvec3 degrees{units::degFromRadians(pose.rotationRad.x),
                             units::degFromRadians(pose.rotationRad.y),
                             units::degFromRadians(pose.rotationRad.z)};
    const glm::dvec3 turned = vector(table, "rotation_deg", kAngle, degrees);
    pose.rotationRad = {units::radiansFromDeg(turned.x), units::radiansFromDeg(turned.y),
                        units::radiansFromDeg(turned.z)};
    pose.scale = vector(table, "axis_scale", kScale, pose.scale);
    pose.angleScale = vector(table, "angle_scale", kScale, pose.angleScale);
}

/// A rig file of both cameras, or of a colour camera alone.
calib::CameraModel colorCamera(TomlReader& table, const std::filesystem::path& file) {
    if (file.extension() == ".json") return loadRig(file).color;
    const RigFile rig = readRigFile(file);
    if (!rig.color) table.reject("camera_rig", "has no colour camera: " + file.string());
    return *rig.color;
}

void readCamera(TomlReader& table, const std::filesystem::path& folder,
                devices::ViewerParams& viewer) {
    constexpr double kWidest = 170;
    viewer.fieldOfViewRad = units::radiansFromDeg(
        table.number("camera_fov_deg", {0, kWidest}, units::degFromRadians(viewer.fieldOfViewRad)));
    if (!table.has("camera_rig")) return;
    const std::string file = table.text("camera_rig", "");
    viewer.camera = std::nullopt;
    if (!file.empty()) viewer.camera = colorCamera(table, folder / file);
}

} // namespace

void readViewer(TomlReader& root, const std::filesystem::path& folder,
                devices::ViewerParams& viewer) {
    constexpr std::string_view kTrace = "file:";
    auto table = root.table("viewer");
    viewer.source = table.text("source", viewer.source);
    if (table.has("source") && viewer.source.starts_with(kTrace))
        viewer.source = std::string(kTrace) +
                        (folder / viewer.source.substr(kTrace.size())).lexically_normal().string();
    viewer.delay = milliseconds(table, "delay_ms", {0, 500}, viewer.delay);
    viewer.spacingM = units::metresFromMm(
        table.number("eye_spacing_mm", {30, 90}, units::mmFromMetres(viewer.spacingM)));
    viewer.lostAfter = milliseconds(table, "lost_after_ms", {20, 5000}, viewer.lostAfter);
    viewer.ease = milliseconds(table, "ease_ms", {0, 5000}, viewer.ease);
    auto& smoothing = viewer.smoothing;
    smoothing.cutoffHz = table.number("cutoff_hz", {0.1, 100}, smoothing.cutoffHz);
    smoothing.cutoffPerSpeed =
        table.number("cutoff_per_speed", {0, 1000}, smoothing.cutoffPerSpeed);
    smoothing.velocityCutoffHz =
        table.number("velocity_cutoff_hz", {0.1, 100}, smoothing.velocityCutoffHz);
    smoothing.restSpeed = table.number("rest_speed", {0, 10}, smoothing.restSpeed);
    readPose(table, viewer.pose);
    readCamera(table, folder, viewer);
}

} // namespace autostereo::config
