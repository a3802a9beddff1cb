#include "config/rig_file.hpp"

#include "config/load.hpp"
#include "config/text_file.hpp"
#include "config/toml_reader.hpp"
#include "config/toml_text.hpp"
#include "config/units.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <array>
#include <cmath>
#include <cstdio>

namespace autostereo::config {

namespace {

constexpr int kVersion = 1;

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

void readQuality(TomlReader table, RigFile& rig) {
    for (const QualityKey& entry : qualityKeys())
        if (table.has(entry.key))
            rig.quality[std::string(entry.key)] = table.number(entry.key, {-1e6, 1e6});
    if (table.has("warnings")) rig.warnings = table.words("warnings", {0, 100});
}

/// `wholeOnly`: what is missing is an error.
RigFile readText(const std::string& name, std::string_view text, bool wholeOnly) {
    TomlReader root(name, text);
    RigFile rig;
    static_cast<void>(root.integer("version", {kVersion, kVersion}, kVersion));
    rig.provenance = root.text("provenance");
    const bool hasCamera = root.has("depth") || root.has("color");
    if (wholeOnly || !hasCamera || root.has("depth")) rig.depth = readCamera(root.table("depth"));
    if (wholeOnly || root.has("color")) rig.color = readCamera(root.table("color"));
    if (wholeOnly || root.has("color_from_depth"))
        rig.colorFromDepth = readTransform(root.table("color_from_depth"));
    constexpr Range kLateMs{-100, 100};
    rig.colorLateS = units::secondsFromMs(root.table("timing").number("color_late_ms", kLateMs, 0));
    readQuality(root.table("quality"), rig);
    root.finish();
    return rig;
}

void writeCamera(TomlText& toml, const char* name, const calib::CameraModel& camera) {
    const calib::Intrinsics& i = camera.intrinsics;
    const calib::Distortion& k = camera.distortion;
    toml.table(name);
    toml.integer("width", i.width);
    toml.integer("height", i.height);
    toml.number("fx", i.fx);
    toml.number("fy", i.fy);
    toml.number("cx", i.cx);
    toml.number("cy", i.cy);
    toml.table(std::string(name) + ".distortion");
    const std::array<std::pair<const char*, double>, 8> terms{{{"k1", k.k1},
                                                               {"k2", k.k2},
                                                               {"p1", k.p1},
                                                               {"p2", k.p2},
                                                               {"k3", k.k3},
                                                               {"k4", k.k4},
                                                               {"k5", k.k5},
                                                               {"k6", k.k6}}};
    for (const auto& [term, value] : terms)
        if (value != 0) toml.number(term, value);
    if (std::isfinite(k.metricRadius)) toml.number("metric_radius", k.metricRadius);
}

void writeTransform(TomlText& toml, const calib::RigidTransform& transform) {
    toml.table("color_from_depth");
    const glm::dmat3 rows = glm::transpose(transform.rotation); // GLM stores columns
    const double* first = glm::value_ptr(rows);
    toml.numbers("rotation", {first, first + 9});
    const glm::dvec3& t = transform.translation;
    toml.numbers("translation_m", {t.x, t.y, t.z});
}

std::string told(const char* form, double number) {
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(), form, number);
    return text.data();
}

std::string cameraLine(const char* which, const calib::CameraModel& camera) {
    const calib::Intrinsics& i = camera.intrinsics;
    return std::string(which) + ": " + std::to_string(i.width) + "x" + std::to_string(i.height) +
           told(", focal length %.1f", i.fx) + told(" x %.1f px", i.fy) +
           told(", centre %.1f", i.cx) + told(", %.1f", i.cy);
}

} // namespace

const std::vector<QualityKey>& qualityKeys() {
    static const std::vector<QualityKey> keys{
        {"depth_views", "depth camera: %.0f views of the board"},
        {"depth_rms_px", "depth camera: %.3f px rms"},
        {"depth_left_out_px", "depth camera: %.3f px rms in views left out"},
        {"depth_focal_95_px", "depth camera: focal length within +- %.2f px (95 %%)"},
        {"depth_condition", "depth camera: condition %.0f"},
        {"color_views", "colour camera: %.0f views of the board"},
        {"color_rms_px", "colour camera: %.3f px rms"},
        {"color_left_out_px", "colour camera: %.3f px rms in views left out"},
        {"color_focal_95_px", "colour camera: focal length within +- %.2f px (95 %%)"},
        {"color_condition", "colour camera: condition %.0f"},
        {"pairs", "both cameras: %.0f pairs"},
        {"points", "both cameras: %.0f points"},
        {"separate_rms_px", "both cameras, each as found alone: %.3f px rms"},
        {"rms_px", "both cameras: %.3f px rms"},
        {"rotation_95_deg", "rotation within +- %.3f degrees (95 %%)"},
        {"translation_95_mm", "translation within +- %.2f mm (95 %%)"},
        {"registration_95_mm_at_500_mm", "colour lies within %.2f mm at 0.5 m (95 %%)"},
        {"registration_95_mm_at_1000_mm", "colour lies within %.2f mm at 1 m (95 %%)"},
        {"registration_95_mm_at_2000_mm", "colour lies within %.2f mm at 2 m (95 %%)"},
        {"registration_95_mm_at_3000_mm", "colour lies within %.2f mm at 3 m (95 %%)"},
        {"color_late_95_ms", "colour camera: its stamps' lateness within +- %.2f ms (95 %%)"},
        {"depth_bias_mm", "depth camera: measures %+.1f mm too far at 1 m"},
        {"depth_bias_95_mm", "depth camera: that within +- %.1f mm (95 %%)"},
        {"depth_bias_mm_per_m", "depth camera: and %+.1f mm more per metre beyond"},
        {"depth_bias_dark_mm", "depth camera: dark squares %+.1f mm farther than bright ones"}};
    return keys;
}

RigFile readRigFile(const std::filesystem::path& file) {
    return readText(file.string(), readTextFile(file), false);
}

calib::SensorRig wholeRig(const std::string& name, std::string_view text) {
    const RigFile rig = readText(name, text, true);
    return {*rig.depth, *rig.color, *rig.colorFromDepth, rig.provenance, rig.colorLateS};
}

std::string rigText(const RigFile& rig) {
    TomlText toml;
    toml.comment("Pixels; the centre of the first pixel is (0, 0). Cameras look along z, x right,");
    toml.comment("y down. Intervals hold the truth in 95 of 100 calibrations.");
    toml.integer("version", kVersion);
    toml.text("provenance", rig.provenance);
    if (rig.depth) writeCamera(toml, "depth", *rig.depth);
    if (rig.color) writeCamera(toml, "color", *rig.color);
    if (rig.colorFromDepth) writeTransform(toml, *rig.colorFromDepth);
    if (rig.colorLateS != 0) {
        toml.table("timing");
        toml.number("color_late_ms", units::msFromSeconds(rig.colorLateS));
    }
    if (rig.quality.empty() && rig.warnings.empty()) return toml.str();
    toml.table("quality");
    for (const QualityKey& entry : qualityKeys())
        if (const auto found = rig.quality.find(std::string(entry.key));
            found != rig.quality.end() && std::isfinite(found->second))
            toml.number(entry.key, found->second);
    toml.words("warnings", rig.warnings);
    return toml.str();
}

std::vector<std::string> explained(const RigFile& rig) {
    std::vector<std::string> lines;
    if (rig.depth) lines.push_back(cameraLine("depth camera", *rig.depth));
    if (rig.color) lines.push_back(cameraLine("colour camera", *rig.color));
    if (rig.colorFromDepth) {
        const glm::dvec3 at = 1e3 * (rig.colorFromDepth->inverse() * glm::dvec3(0));
        lines.push_back(told("colour camera stands %.1f", at.x) + told(", %.1f", at.y) +
                        told(", %.1f mm from the depth camera (right, down, ahead)", at.z));
    }
    if (rig.colorLateS != 0)
        lines.push_back(
            told("colour camera: stamped %.2f ms late", units::msFromSeconds(rig.colorLateS)));
    for (const QualityKey& entry : qualityKeys())
        if (const auto found = rig.quality.find(std::string(entry.key)); found != rig.quality.end())
            lines.push_back(told(entry.form, found->second));
    for (const std::string& warning : rig.warnings)
        lines.push_back("warning: " + warning);
    return lines;
}

} // namespace autostereo::config
