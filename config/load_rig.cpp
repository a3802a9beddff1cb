#include "config/load.hpp"
#include "config/phrases.hpp"
#include "config/text_file.hpp"
#include "config/toml_reader.hpp"
#include "devices/input.hpp"
#include "devices/replay/calibration_files.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <cmath>
#include <string>

namespace autostereo::config {

namespace {

calib::Distortion readDistortion(TomlReader table) {
    constexpr Range kTerm{-1000, 1000};
    calib::Distortion k;
    k.k1 = table.number("k1", kTerm, 0);
    k.k2 = table.number("k2", kTerm, 0);
    k.p1 = table.number("p1", kTerm, 0);
    k.p2 = table.number("p2", kTerm, 0);
    k.k3 = table.number("k3", kTerm, 0);
    k.k4 = table.number("k4", kTerm, 0);
    k.k5 = table.number("k5", kTerm, 0);
    k.k6 = table.number("k6", kTerm, 0);
    k.metricRadius = table.number("metric_radius", {0.01, 100}, k.metricRadius);
    return k;
}

calib::CameraModel readCamera(TomlReader table) {
    calib::CameraModel camera;
    camera.intrinsics.width = table.integer("width", {1, 16384});
    camera.intrinsics.height = table.integer("height", {1, 16384});
    camera.intrinsics.fx = table.number("fx", {1, 1e6});
    camera.intrinsics.fy = table.number("fy", {1, 1e6});
    camera.intrinsics.cx = table.number("cx", {-1e6, 1e6});
    camera.intrinsics.cy = table.number("cy", {-1e6, 1e6});
    camera.distortion = readDistortion(table.table("distortion"));
    return camera;
}

/// Three orthonormal axes, right-handed, within the digits that people type.
bool isRotation(const glm::dmat3& m) {
    constexpr double kTolerance = 1e-3;
    const glm::dmat3 product = m * glm::transpose(m);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (std::abs(product[column][row] - (column == row ? 1 : 0)) > kTolerance) return false;
    return glm::determinant(m) > 0;
}

calib::RigidTransform readTransform(TomlReader table) {
    calib::RigidTransform transform;
    const auto rows = table.numbers<9>("rotation", {-1.001, 1.001});
    transform.rotation = glm::transpose(glm::make_mat3(rows.data())); // GLM stores columns
    if (!isRotation(transform.rotation))
        table.reject("rotation", "is no rotation (allowed orthonormal rows within 0.001, "
                                 "determinant +1)");
    const auto metres = table.numbers<3>("translation_m", {-10, 10});
    transform.translation = {metres[0], metres[1], metres[2]};
    return transform;
}

calib::SensorRig readRig(const std::string& name, std::string_view text) {
    TomlReader root(name, text);
    calib::SensorRig rig;
    rig.provenance = root.text("provenance");
    rig.depth = readCamera(root.table("depth"));
    rig.color = readCamera(root.table("color"));
    rig.colorFromDepth = readTransform(root.table("color_from_depth"));
    root.finish();
    return rig;
}

/// camera.json is read where recordings are, which carry it too.
calib::SensorRig readCameraJson(const std::filesystem::path& file) {
    try {
        return devices::readCameraFile(file).rig();
    } catch (const devices::DeviceError& error) {
        throw ConfigError(oneLine(error.what()));
    }
}

} // namespace

calib::SensorRig loadRig(const std::filesystem::path& file) {
    if (file.extension() == ".json") return readCameraJson(file);
    return readRig(file.string(), readTextFile(file));
}

calib::SensorRig exampleRig() {
    constexpr std::string_view kName = "rigs/example.toml";
    return readRig(std::string(kName), embeddedText(kName));
}

} // namespace autostereo::config
