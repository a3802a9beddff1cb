#include "tests/replay/program.hpp"

#include "tests/support/small_display.hpp"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

namespace autostereo::test {

namespace {

std::vector<std::string> complaints(const std::string& err) {
    std::vector<std::string> lines;
    std::istringstream text(err);
    for (std::string line; std::getline(text, line);)
        if (!line.starts_with("[info] ") && !line.starts_with("[warning] ")) lines.push_back(line);
    return lines;
}

RunReport::Stream streamOf(const nlohmann::json& json) {
    return {json.at("in"), json.at("paired"), json.at("unpaired"), json.at("damaged")};
}

} // namespace

TempFolder::TempFolder() {
    std::string name = std::filesystem::temp_directory_path() / "autostereo-test-XXXXXX";
    if (mkdtemp(name.data()) == nullptr)
        throw std::system_error(errno, std::generic_category(), name);
    path_ = name;
}

TempFolder::~TempFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

std::string TempFolder::file(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
}

std::string smallDisplay(const TempFolder& folder) {
    return folder.file("small.toml", smallDisplayText(320, 180));
}

std::string twoCameras(const TempFolder& folder) {
    const std::string camera = "width = 640\nheight = 480\nfx = 500\nfy = 500\ncx = 320\n"
                               "cy = 240\n";
    return folder.file("cameras.toml",
                       "provenance = \"by hand\"\n[depth]\n" + camera + "[color]\n" + camera +
                           "[color_from_depth]\nrotation = [1, 0, 0, 0, 1, 0, 0, 0, 1]\n"
                           "translation_m = [0, 0, 0]\n");
}

std::string cameraFile(const TempFolder& folder, int width, int height) {
    const nlohmann::json camera{
        {"width", width},        {"height", height},        {"fx", width},
        {"fy", width},           {"cx", (width - 1) / 2.0}, {"cy", (height - 1) / 2.0},
        {"depth_scale_m", 0.001}};
    return folder.file("camera.json", nlohmann::json{{"depth", camera}, {"color", camera}}.dump());
}

ProgramCall calling(std::vector<std::string> arguments) {
    ProgramCall call;
    call.program = AUTOSTEREO_PROGRAM;
    call.arguments = std::move(arguments);
    call.environment = {"DISPLAY=", "WAYLAND_DISPLAY=", "XDG_RUNTIME_DIR=", "RUNTIME_DIRECTORY="};
    call.limit *= kSlower;
    return call;
}

testing::AssertionResult succeeded(const ProgramResult& result) {
    if (result.exitCode == 0 && complaints(result.err).empty()) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "exit code " << result.exitCode
                                       << (result.timedOut ? " (killed: too long)" : "") << "\n"
                                       << result.err;
}

testing::AssertionResult failedPlainly(const ProgramResult& result, std::optional<int> exitCode) {
    const auto lines = complaints(result.err);
    const bool codeFits =
        exitCode ? result.exitCode == *exitCode : result.exitCode >= 1 && result.exitCode <= 3;
    if (codeFits && !result.timedOut && lines.size() == 1 &&
        lines.front().starts_with("autostereo: "))
        return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "exit code " << result.exitCode << (result.timedOut ? " (killed: too long)" : "")
           << ", " << lines.size() << " lines of errors\n"
           << result.err;
}

RunReport readReport(const std::string& file) {
    std::ifstream text(file);
    const auto json = nlohmann::json::parse(text);
    RunReport report;
    report.accounts = {streamOf(json.at("streams").at("depth")),
                       streamOf(json.at("streams").at("color")),
                       json.at("frames_in"),
                       json.at("frames_presented"),
                       json.at("frames_skipped"),
                       json.at("frames_dropped"),
                       json.at("frames_without_depth")};
    if (const auto& latency = json.at("latency_ms"); !latency.is_null()) {
        report.latencyP50Ms = latency.at("p50");
        report.latencyP99Ms = latency.at("p99");
    }
    report.seconds = json.at("seconds");
    report.renderer = json.at("renderer");
    return report;
}

testing::AssertionResult balanced(const RunReport& report) {
    const RunReport::Accounts& all = report.accounts;
    for (const RunReport::Stream& stream : {all.depth, all.color})
        if (stream.in != stream.paired + stream.unpaired || stream.paired != all.framesIn)
            return testing::AssertionFailure()
                   << "stream: " << stream.in << " in, " << stream.paired << " paired, "
                   << stream.unpaired << " unpaired; " << all.framesIn << " pairs";
    if (all.framesIn != all.presented + all.skipped + all.dropped)
        return testing::AssertionFailure()
               << all.framesIn << " pairs in, " << all.presented << " presented, " << all.skipped
               << " skipped, " << all.dropped << " dropped";
    return testing::AssertionSuccess();
}

} // namespace autostereo::test
