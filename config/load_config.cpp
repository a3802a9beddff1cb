#include "config/durations.hpp"
#include "config/load.hpp"
#include "config/phrases.hpp"
#include "config/read_framing.hpp"
#include "config/read_scene.hpp"
#include "config/read_service.hpp"
#include "config/read_viewer.hpp"
#include "config/text_file.hpp"
#include "config/toml_reader.hpp"
#include "config/units.hpp"
#include "config/vendor_calibration.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <string>

namespace autostereo::config {

namespace {

void readTiming(TomlReader& root, Config& config) {
    auto sync = root.table("sync");
    config.sync.tolerance = milliseconds(sync, "tolerance_ms", {0, 1000}, config.sync.tolerance);

    auto reconnect = root.table("reconnect");
    auto& delays = config.reconnect;
    delays.firstDelay = milliseconds(reconnect, "first_delay_ms", {1, 60000}, delays.firstDelay);
    delays.longestDelay =
        milliseconds(reconnect, "longest_delay_ms", {1, 600000}, delays.longestDelay);
    if (delays.longestDelay < delays.firstDelay)
        reconnect.reject("longest_delay_ms",
                         "is less than first_delay_ms (allowed first_delay_ms to 600000)");
}

void readNoise(TomlReader& table, calib::DepthNoise& noise) {
    const auto millimetres = [&](std::string_view key, Range range, double fallback) {
        return units::metresFromMm(table.number(key, range, units::mmFromMetres(fallback)));
    };
    noise.floorM = millimetres("noise_floor_mm", {0, 1000}, noise.floorM);
    noise.shotM = millimetres("noise_shot_mm", {0, 1e6}, noise.shotM);
    noise.growthPerM = millimetres("noise_growth_mm", {0, 1000}, noise.growthPerM);
}

void readCondition(TomlReader& root, gpu::PipelineParams& pipeline) {
    auto table = root.table("condition");
    gpu::ConditionParams& params = pipeline.condition;
    pipeline.color.sigma = table.number("color_noise_levels", {0, 20}, pipeline.color.sigma);
    params.validity = table.boolean("validity", params.validity);
    params.weakestAmplitude =
        table.integer("weakest_amplitude", {0, 65534}, params.weakestAmplitude);
    params.saturatedAmplitude =
        table.integer("saturated_amplitude", {1, 65535}, params.saturatedAmplitude);
    if (params.saturatedAmplitude <= params.weakestAmplitude)
        table.reject("saturated_amplitude",
                     "is not more than weakest_amplitude (allowed weakest_amplitude to 65535)");
    params.confidence = table.boolean("confidence", params.confidence);
    readNoise(table, params.noise);
    params.flyingPixels = table.boolean("flying_pixels", params.flyingPixels);
    params.grazingRad = units::radiansFromDeg(
        table.number("grazing_deg", {10, 89}, units::degFromRadians(params.grazingRad)));
    params.edgeSigmas = table.number("edge_sigmas", {0, 20}, params.edgeSigmas);
    params.hold = table.boolean("hold", params.hold);
    params.gateSigmas = table.number("gate_sigmas", {1, 20}, params.gateSigmas);
    params.settleFrames = table.integer("settle_frames", {1, 64}, params.settleFrames);
    params.keepFrames = table.integer("keep_frames", {0, 250}, params.keepFrames);
    params.fillHoles = table.boolean("fill_holes", params.fillHoles);
    params.holeWidth = table.integer("hole_width", {0, 8}, params.holeWidth);
}

void readSynthesis(TomlReader& root, gpu::PipelineParams& pipeline) {
    auto table = root.table("synthesis");
    pipeline.skipUnchanged = table.boolean("skip_unchanged", pipeline.skipUnchanged);
    gpu::SynthesisParams& params = pipeline.synthesis;
    params.method = table.choice<gpu::Method>("method", gpu::kMethods, params.method);
    params.positions = table.choice<gpu::ViewPositions>(
        "positions",
        {{"continuous", gpu::ViewPositions::Continuous}, {"views", gpu::ViewPositions::OfViews}},
        params.positions);
    params.filter = table.choice<gpu::TileFilter>(
        "filter", {{"nearest", gpu::TileFilter::Nearest}, {"linear", gpu::TileFilter::Linear}},
        params.filter);
    params.keepRoots = table.boolean("keep_roots", params.keepRoots);
    params.leastDb = table.number("max_error_db", {0, 55}, params.leastDb);
    params.tileScale = table.number("tile_scale", {0.05, 4}, params.tileScale);
    params.viewsPerPass = table.integer("views_per_pass", {0, 64}, params.viewsPerPass);
    params.references = table.integer("references", {2, 5}, params.references);
}

void readPipeline(TomlReader& root, gpu::PipelineParams& params) {
    readCondition(root, params);
    auto mesh = root.table("mesh");
    params.mesh.nearestM = mesh.number("nearest_m", {0.01, 10}, params.mesh.nearestM);
    params.mesh.farthestM = mesh.number("farthest_m", {0.1, 100}, params.mesh.farthestM);
    if (params.mesh.farthestM <= params.mesh.nearestM)
        mesh.reject("farthest_m", "is not farther than nearest_m (allowed nearest_m to 100)");
    params.mesh.cutRatio = mesh.number("cut_ratio", {0.005, 0.5}, params.mesh.cutRatio);

    auto fusion = root.table("fusion");
    params.fusion.density = fusion.number("density", {0.25, 4}, params.fusion.density);
    params.fusion.mostTexels =
        fusion.integer("most_texels", {1000, 4'000'000}, params.fusion.mostTexels);
    params.fusion.edgeBandPx = fusion.number("edge_band_px", {0, 8}, params.fusion.edgeBandPx);
    params.fusion.edgeReachPx = fusion.number("edge_reach_px", {0, 32}, params.fusion.edgeReachPx);
    params.fusion.remember = fusion.boolean("remember", params.fusion.remember);
    params.fusion.fillReach = fusion.integer("fill_reach", {1, 1024}, params.fusion.fillReach);

    auto registration = root.table("registration");
    params.registration.extrudePx =
        registration.integer("extrude_px", {0, 16}, params.registration.extrudePx);

    readSynthesis(root, params);
}

/// The two ends of an interval: rising, each within the range.
void readInterval(TomlReader& table, const char* key, Range range, double& least, double& most) {
    const auto ends = table.numbers<2>(key, range, std::array{least, most});
    if (ends[1] < ends[0]) table.reject(key, "ends before it begins (allowed [least, most])");
    least = ends[0];
    most = ends[1];
}

void readDepth(TomlReader& root, Config& config) {
    auto depth = root.table("depth");
    auto& budget = config.pipeline.budget;
    budget.focusM = depth.numberOrAuto("focus_m", {0.05, 100}, budget.focusM);
    budget.depthScale = depth.numberOrAuto("scale", {0, 10}, budget.depthScale);
    config.depthFollows = depth.choice<Following>(
        "follow",
        {{"live", Following::Live}, {"always", Following::Always}, {"never", Following::Never}},
        config.depthFollows);
    auto& limits = budget.limits;
    readInterval(depth, "focus_range_m", {0.05, 100}, limits.nearestFocusM, limits.farthestFocusM);
    readInterval(depth, "scale_range", {0, 10}, limits.leastScale, limits.mostScale);
    const auto percent = [&](const char* key, double share) {
        return depth.number(key, {0, 100}, 100 * share) / 100;
    };
    budget.nearShare = percent("near_percent", budget.nearShare);
    budget.subjectShare = percent("subject_percent", budget.subjectShare);
    budget.farShare = percent("far_percent", budget.farShare);
    if (budget.farShare < budget.nearShare)
        depth.reject("far_percent", "is less than near_percent (allowed near_percent to 100)");
    auto& motion = budget.motion;
    motion.timeConstantS = depth.number("time_constant_s", {0.05, 60}, motion.timeConstantS);
    motion.deadBand = depth.number("dead_band", {0, 1}, motion.deadBand);
}

/// A file by its name as the configuration gives it: relative names start from its folder.
std::string fileFrom(const std::filesystem::path& folder, const std::string& name) {
    return (folder / name).lexically_normal().string();
}

/// A number as it is, all else in quotes.
std::string tomlValue(const std::string& text) {
    double number = 0;
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    if (error == std::errc{} && rest == end && std::isfinite(number)) return plain(number);
    std::string quoted = "\"";
    for (const char c : oneLine(text)) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + '"';
}

/// Every key a configuration may have; those not in the file keep their value. Files that it names
/// are looked for in `folder`.
void readConfig(TomlReader& root, const std::filesystem::path& folder, Config& config) {
    auto input = root.table("input");
    config.input = input.text("uri", config.input);
    config.color = input.textOrAuto("color", config.color);
    config.rig = input.textOrAuto("rig", config.rig);
    if (config.rig && input.has("rig")) config.rig = fileFrom(folder, *config.rig);
    config.wait = input.choice<std::optional<bool>>(
        "wait", {{"auto", std::nullopt}, {"yes", true}, {"no", false}}, config.wait);

    auto display = root.table("display");
    config.display = display.textOrAuto("profile", config.display).value_or("");
    const std::string kind = std::filesystem::path(config.display).extension();
    if (display.has("profile") && (kind == ".toml" || kind == ".json"))
        config.display = fileFrom(folder, config.display);

    auto output = root.table("output");
    config.output = output.choice<std::optional<Output>>(
        "kind",
        {{"auto", std::nullopt}, {"window", Output::Window}, {"offscreen", Output::Offscreen}},
        config.output);
    config.refreshHz = output.number("refresh_hz", {0, 500}, config.refreshHz);

    readTiming(root, config);
    readPipeline(root, config.pipeline);
    readDepth(root, config);
    auto picture = root.table("picture");
    auto& clearColor = config.pipeline.clearColor;
    clearColor = picture.numbers<3>("clear_color", {0, 1}, clearColor);
    config.brightness = picture.number("brightness", {0, 1}, config.brightness);
    config.flat = picture.choice<bool>("mode", {{"3d", false}, {"2d", true}}, config.flat);

    auto framing = root.table("framing");
    readFraming(framing, folder, config.pipeline);
    readScene(root, config.scene);
    readViewer(root, folder, config.viewer);

    readService(root, folder, config);
    auto log = root.table("log");
    config.log.level = log.choice<std::string>("level",
                                               {{"error", "error"},
                                                {"warn", "warn"},
                                                {"info", "info"},
                                                {"debug", "debug"},
                                                {"trace", "trace"}},
                                               config.log.level);
    root.finish();
}

} // namespace

Config defaultConfig() {
    constexpr std::string_view kName = "default.toml";
    TomlReader root(std::string(kName), embeddedText(kName), TomlReader::Fallbacks::Refused);
    Config config;
    readConfig(root, {}, config);
    return config;
}

Config loadConfig(const std::filesystem::path& file) {
    TomlReader root(file.string(), readTextFile(file));
    Config config = defaultConfig();
    readConfig(root, file.parent_path(), config);
    return config;
}

Config changed(Config config, const std::string& name, const std::string& value) {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kSettings{
        {{"scale", "depth.scale"},
         {"focus", "depth.focus_m"},
         {"method", "synthesis.method"},
         {"brightness", "picture.brightness"},
         {"mode", "picture.mode"}}};
    std::vector<std::string_view> names;
    for (const auto& [known, key] : kSettings) {
        names.push_back(known);
        if (known != name) continue;
        // As a file of one line: the same ranges, the same words.
        try {
            TomlReader root("set", std::string(key) + " = " + tomlValue(value));
            readConfig(root, {}, config);
            return config;
        } catch (const ConfigError& error) {
            const std::string what = error.what(); // "set:1:15: depth.scale: ..."
            throw ConfigError("set " + name + ": " + what.substr(what.find(": ") + 2));
        }
    }
    throw ConfigError(oneLine("set " + name + ": unknown " + allowed(names)));
}

FileKind kindOf(const std::filesystem::path& file) {
    if (file.extension() == ".json")
        return vendorOf(readTextFile(file)) ? FileKind::Display : FileKind::Rig;
    const TomlReader root(file.string(), readTextFile(file));
    if (root.has("type") || root.has("panel")) return FileKind::Display;
    if (root.has("color_from_depth") || root.has("color") || root.has("provenance"))
        return FileKind::Rig;
    return FileKind::Config;
}

} // namespace autostereo::config
