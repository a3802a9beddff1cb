#include "devices/replay/calibration_files.hpp"

#include "devices/input.hpp"
#include "devices/replay/image_files.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <string_view>
#include <vector>

namespace autostereo::devices {

namespace {

using nlohmann::json;

constexpr std::size_t kLargestFile = 16U << 20U; // bytes; real files have a few thousand

/// A JSON object and where it stands, so that every complaint names file and key.
struct Node {
    const json& value;
    std::string where; ///< "file: depth"

    [[noreturn]] void fail(const std::string& key, const std::string& wrong) const {
        throw DeviceError(where + key + ": " + wrong);
    }
    [[nodiscard]] bool has(const char* key) const {
        return value.is_object() && value.contains(key);
    }
    [[nodiscard]] Node at(const char* key) const {
        if (!has(key)) fail(key, "missing");
        return {value.at(key), where + key + "."};
    }
    [[nodiscard]] double number(const char* key) const {
        if (!has(key)) fail(key, "missing (a number is needed)");
        const json& found = value.at(key);
        if (!found.is_number()) fail(key, "is no number");
        return found.get<double>();
    }
    [[nodiscard]] double number(const char* key, double fallback) const {
        return has(key) ? number(key) : fallback;
    }
    [[nodiscard]] int size(const char* key) const {
        const double found = number(key);
        if (!(found >= 1) || !(found <= kLargestSide) || found != std::floor(found))
            fail(key, "is " + value.at(key).dump() + " (allowed 1 to 16384)");
        return static_cast<int>(found);
    }
    /// Between `fewest` and `most` numbers.
    [[nodiscard]] std::vector<double> numbers(const char* key, std::size_t fewest,
                                              std::size_t most) const {
        if (!has(key)) fail(key, "missing (" + std::to_string(fewest) + " numbers are needed)");
        const json& found = value.at(key);
        std::vector<double> result;
        if (found.is_array() && found.size() >= fewest && found.size() <= most)
            for (const json& entry : found)
                if (entry.is_number()) result.push_back(entry.get<double>());
        if (result.size() < fewest || result.size() != found.size())
            fail(key, "wrong list (allowed " + std::to_string(fewest) + " numbers)");
        return result;
    }
};

json parse(std::span<const std::byte> bytes, const std::string& name) try {
    const auto* text = reinterpret_cast<const char*>(bytes.data());
    return json::parse(text, text + bytes.size());
} catch (const json::exception& error) {
    throw DeviceError(name + ": not valid JSON: " + error.what());
}

void check(const calib::CameraModel& camera, const Node& node) {
    if (const auto problem = calib::problemWith(camera)) throw DeviceError(node.where + *problem);
}

calib::RigidTransform transformFrom(const std::vector<double>& rowMajor,
                                    const std::vector<double>& translation, const Node& node) {
    calib::RigidTransform result;
    for (std::size_t row = 0; row < 3; ++row) {
        const auto component = static_cast<glm::length_t>(row);
        for (std::size_t column = 0; column < 3; ++column)
            result.rotation[static_cast<glm::length_t>(column)][component] =
                rowMajor[3 * row + column];
        result.translation[component] = translation[row];
    }
    // Factory rotations are orthonormal to 1e-6; a scaled or mistyped one is off by far more.
    constexpr double kTolerance = 1e-3;
    const glm::dmat3 unit = result.rotation * glm::transpose(result.rotation);
    for (int i = 0; i < 9; ++i)
        if (!(std::abs(unit[i / 3][i % 3] - (i % 4 == 0 ? 1.0 : 0.0)) < kTolerance))
            node.fail("rotation", "is no rotation (allowed orthonormal rows)");
    if (!(glm::determinant(result.rotation) > 0)) node.fail("rotation", "is a mirror image");
    return result;
}

calib::CameraModel cameraFrom(const Node& node) {
    calib::CameraModel camera;
    calib::Intrinsics& i = camera.intrinsics;
    i.width = node.size("width");
    i.height = node.size("height");
    i.fx = node.number("fx");
    i.fy = node.number("fy");
    i.cx = node.number("cx");
    i.cy = node.number("cy");
    if (constexpr const char* kKey = "distortion_k1k2p1p2k3k4k5k6"; node.has(kKey)) {
        const auto k = node.numbers(kKey, 8, 8);
        camera.distortion = {k[0], k[1], k[2], k[3], k[4], k[5], k[6], k[7]};
    }
    camera.distortion.metricRadius = node.number("metric_radius", camera.distortion.metricRadius);
    check(camera, node);
    return camera;
}

calib::CameraModel open3dCamera(const Node& node) {
    const auto m = node.numbers("intrinsic_matrix", 9, 9);
    calib::CameraModel camera;
    camera.intrinsics = {node.size("width"), node.size("height"), m[0], m[4], m[6], m[7]};
    check(camera, node);
    return camera;
}

double depthUnit(const Node& depth) {
    const double unit = depth.number("depth_scale_m");
    if (!(unit > 0 && unit <= 1)) depth.fail("depth_scale_m", "out of range (allowed 0 to 1 m)");
    return unit;
}

} // namespace

calib::SensorRig CameraFile::rig() const {
    calib::SensorRig result;
    result.depth = depth ? *depth : *color;
    result.color = color ? *color : *depth;
    result.colorFromDepth = colorFromDepth;
    result.provenance = name;
    return result;
}

CameraFile readCameraFile(const std::filesystem::path& path) {
    return readCameraFile(readFile(path, kLargestFile), path.string());
}

CameraFile readCameraFile(std::span<const std::byte> bytes, const std::string& name) {
    const json text = parse(bytes, name);
    const Node root{text, name + ": "};
    CameraFile file;
    file.name = name;
    if (root.has("intrinsic_matrix")) {
        file.color = open3dCamera(root);
        return file;
    }
    if (!root.has("depth") && !root.has("color"))
        root.fail("depth", "missing, and so is color (one of them is needed)");
    if (root.has("color")) file.color = cameraFrom(root.at("color"));
    if (root.has("depth")) {
        const Node depth = root.at("depth");
        file.depth = cameraFrom(depth);
        if (depth.has("depth_scale_m")) file.depthUnitM = depthUnit(depth);
    }
    if (root.has("depth_to_color")) {
        const Node pose = root.at("depth_to_color");
        file.colorFromDepth =
            transformFrom(pose.numbers("R_rowmajor", 9, 9), pose.numbers("t_m", 3, 3), pose);
    }
    return file;
}

namespace {

json nodeOf(const calib::CameraModel& camera) {
    const calib::Intrinsics& i = camera.intrinsics;
    const calib::Distortion& d = camera.distortion;
    json node{{"width", i.width}, {"height", i.height}, {"fx", i.fx},
              {"fy", i.fy},       {"cx", i.cx},         {"cy", i.cy}};
    node["distortion_k1k2p1p2k3k4k5k6"] = {d.k1, d.k2, d.p1, d.p2, d.k3, d.k4, d.k5, d.k6};
    if (std::isfinite(d.metricRadius)) node["metric_radius"] = d.metricRadius;
    return node;
}

} // namespace

std::string cameraFile(const calib::SensorRig& rig) {
    const calib::RigidTransform& pose = rig.colorFromDepth;
    std::vector<double> rows;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            rows.push_back(pose.rotation[column][row]);
    const glm::dvec3& t = pose.translation;
    const json file{{"depth", nodeOf(rig.depth)},
                    {"color", nodeOf(rig.color)},
                    {"depth_to_color", {{"R_rowmajor", rows}, {"t_m", {t.x, t.y, t.z}}}}};
    return file.dump(2) + '\n';
}

namespace {

/// How a mode's picture is cut from the calibrated frame: scaled to `scaled`, then cropped.
struct KinectMode {
    PictureSize picture;
    PictureSize scaled;
    int cropX, cropY;
};

constexpr std::array kDepthModes{
    KinectMode{{320, 288}, {512, 512}, 96, 90},     // narrow, binned
    KinectMode{{640, 576}, {1024, 1024}, 192, 180}, // narrow
    KinectMode{{512, 512}, {512, 512}, 0, 0},       // wide, binned
    KinectMode{{1024, 1024}, {1024, 1024}, 0, 0},   // wide, passive infrared
};
constexpr std::array kColorModes{
    KinectMode{{1280, 720}, {1280, 960}, 0, 120},   KinectMode{{1920, 1080}, {1920, 1440}, 0, 180},
    KinectMode{{2560, 1440}, {2560, 1920}, 0, 240}, KinectMode{{2048, 1536}, {2048, 1536}, 0, 0},
    KinectMode{{3840, 2160}, {3840, 2880}, 0, 360}, KinectMode{{4096, 3072}, {4096, 3072}, 0, 0},
};

const KinectMode& modeOf(std::span<const KinectMode> modes, PictureSize size, const Node& node) {
    for (const KinectMode& mode : modes)
        if (mode.picture == size) return mode;
    node.fail("mode", "no Azure Kinect mode has pictures of " + size.text());
}

Node kinectCamera(const Node& root, std::string_view purpose) {
    const Node list = root.at("CalibrationInformation").at("Cameras");
    if (!list.value.is_array()) list.fail("Purpose", "the cameras are no list");
    for (const json& entry : list.value) {
        if (!entry.is_object()) continue;
        const auto found = entry.find("Purpose");
        if (found != entry.end() && found->is_string() && *found == purpose)
            return {entry, list.where + std::string(purpose) + "."};
    }
    list.fail(std::string(purpose), "missing");
}

/// Parameters: cx cy fx fy k1...k6 codx cody p2 p1 and, in the older model, a radius; normalised
/// to the calibrated frame, whose first pixel's corner is (0, 0).
/// The older model's centre of distortion (codx, cody) is left out: on the unit we have that moves
/// pixels by at most 0.16 (640x576) and 0.44 (1920x1080), 0.05 and 0.13 on average.
calib::CameraModel kinectModel(const Node& node, const KinectMode& mode) {
    const Node intrinsics = node.at("Intrinsics");
    const auto p = intrinsics.numbers("ModelParameters", 14, 32);
    const double width = mode.scaled.width, height = mode.scaled.height;
    calib::CameraModel camera;
    camera.intrinsics = {mode.picture.width,
                         mode.picture.height,
                         p[2] * width,
                         p[3] * height,
                         p[0] * width - mode.cropX - 0.5,
                         p[1] * height - mode.cropY - 0.5};
    camera.distortion = {p[4], p[5], p[13], p[12], p[6], p[7], p[8], p[9]};
    // 0 is the factory's "not known": the model then ends where it stops being one to one.
    if (const double radius = node.number("MetricRadius", 0); radius != 0)
        camera.distortion.metricRadius = radius;
    check(camera, intrinsics);
    return camera;
}

} // namespace

calib::SensorRig readKinectCalibration(std::span<const std::byte> text, const std::string& name,
                                       PictureSize depth, PictureSize color) {
    // A recording's attachment ends in a zero byte.
    while (!text.empty() && text.back() == std::byte{0})
        text = text.first(text.size() - 1);
    const json blob = parse(text, name);
    const Node root{blob, name + ": "};
    calib::SensorRig rig;
    rig.provenance = name;
    const Node depthNode = kinectCamera(root, "CALIBRATION_CameraPurposeDepth");
    const Node colorNode = kinectCamera(root, "CALIBRATION_CameraPurposePhotoVideo");
    const bool hasDepth = depth != PictureSize{}, hasColor = color != PictureSize{};
    if (hasDepth) rig.depth = kinectModel(depthNode, modeOf(kDepthModes, depth, depthNode));
    if (hasColor) rig.color = kinectModel(colorNode, modeOf(kColorModes, color, colorNode));
    if (!hasDepth) rig.depth = rig.color;
    if (!hasColor) rig.color = rig.depth;
    if (hasDepth && hasColor) {
        const Node pose = colorNode.at("Rt");
        rig.colorFromDepth =
            transformFrom(pose.numbers("Rotation", 9, 9), pose.numbers("Translation", 3, 3), pose);
    }
    return rig;
}

} // namespace autostereo::devices
