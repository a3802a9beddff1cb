#include "daemon/session/report.hpp"

#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <numeric>
#include <stdexcept>

namespace autostereo::daemon {

namespace {

using Json = nlohmann::ordered_json;

Json numberOrNull(std::optional<double> number) { return number ? Json(*number) : Json(nullptr); }

Json streamJson(const devices::StreamCounters& stream) {
    return {{"in", stream.in},
            {"paired", stream.paired},
            {"unpaired", stream.unpaired},
            {"pending", stream.pending},
            {"damaged", stream.damaged},
            {"reconnects", stream.reconnects}};
}

Json percentilesJson(const Percentiles& samples, const char* p50, const char* p99) {
    return {{p50, numberOrNull(samples.at(0.5))}, {p99, numberOrNull(samples.at(0.99))}};
}

Json latencyJson(const LatencyParts& parts) {
    Json all = Json::object();
    for (const auto& [name, part] : {std::pair{"transfer", &parts.transfer},
                                     {"pairing", &parts.pairing},
                                     {"wait", &parts.wait},
                                     {"draw", &parts.draw},
                                     {"swap", &parts.swap}})
        all[name] = {{"p50", numberOrNull(part->at(0.5))},
                     {"p99", numberOrNull(part->at(0.99))},
                     {"max", numberOrNull(part->at(1))}};
    return all;
}

Json depthJson(const std::optional<Report::Depth>& depth) {
    if (!depth) return nullptr;
    return {{"focus_m", depth->focusM},
            {"scale", depth->scale},
            {"clamped_share", numberOrNull(depth->clampedShare)}};
}

Json recordingJson(const std::optional<devices::Recorder::Counters>& recording) {
    if (!recording) return nullptr;
    return {{"written", recording->written},
            {"left_out", recording->leftOut},
            {"bytes", recording->bytes},
            {"error", recording->error}};
}

Json toJson(const Report& report) {
    Json stages = Json::object();
    for (std::size_t i = 0; i < report.stageNames.size(); ++i)
        stages[report.stageNames[i]] = percentilesJson(report.stageMs[i], "p50_ms", "p99_ms");
    Json conditioner = Json::object();
    for (const auto& [what, pixels] : report.conditioner)
        conditioner[what] = pixels;
    return {
        {"input", report.input},
        {"display", report.display},
        {"renderer", report.renderer},
        {"method", report.method},
        {"streams",
         {{"depth", streamJson(report.feed.depth)}, {"color", streamJson(report.feed.color)}}},
        {"frames_in", report.feed.pairs},
        {"frames_presented", report.presented},
        {"frames_skipped", report.skippedTotal()},
        {"frames_dropped", report.feed.dropped},
        {"frames_without_depth", report.withoutDepth},
        {"skipped", report.skipped},
        {"conditioner", conditioner},
        {"depth", depthJson(report.depth)},
        {"recording", recordingJson(report.recording)},
        {"search_kept_share", numberOrNull(report.keptShare)},
        {"picture_kept_share", numberOrNull(report.keptPicture)},
        {"fusion_kept_share", numberOrNull(report.keptFusion)},
        {"color_kept_share", report.keptColor},
        {"color_way", report.colorWay},
        {"stages", stages},
        {"gpu", {{"memory_mib", report.gpuMemoryMib}, {"objects", report.gpuObjects}}},
        {"latency_ms", report.latencyMs.at(0.5) ? percentilesJson(report.latencyMs, "p50", "p99")
                                                : Json(nullptr)},
        {"latency_parts_ms", latencyJson(report.latencyParts)},
        {"latency_histogram",
         {{"up_to_ms", Histogram::kUpToMs}, {"frames", report.latencyHistogram.counts()}}},
        {"seconds", report.seconds},
    };
}

} // namespace

std::uint64_t Report::skippedTotal() const {
    return std::accumulate(skipped.begin(), skipped.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const auto& entry) { return sum + entry.second; });
}

std::string Report::summary() const {
    char text[256];
    const double rate = seconds > 0 ? static_cast<double>(presented) / seconds : 0;
    std::snprintf(
        text, sizeof text, "%llu frames in, %llu presented (%.1f/s), %llu skipped, %llu dropped",
        static_cast<unsigned long long>(feed.pairs), static_cast<unsigned long long>(presented),
        rate, static_cast<unsigned long long>(skippedTotal()),
        static_cast<unsigned long long>(feed.dropped));
    std::string line = text;
    const char* separator = ";";
    for (std::size_t i = 0; i < stageNames.size(); ++i) {
        const auto median = stageMs[i].at(0.5);
        if (!median) continue; // results come some frames late
        std::snprintf(text, sizeof text, "%s %s %.1f ms", separator, stageNames[i].c_str(),
                      *median);
        line += text;
        separator = ",";
    }
    if (const auto latency = latencyMs.at(0.5)) {
        std::snprintf(text, sizeof text, "; latency %.1f ms", *latency);
        line += text;
    }
    return line;
}

std::string reportText(const Report& report) { return toJson(report).dump(2); }

void writeReport(const Report& report, const std::filesystem::path& file) {
    const std::filesystem::path partial = file.string() + ".part";
    std::ofstream out(partial);
    out << reportText(report) << '\n';
    out.close();
    if (!out || std::rename(partial.c_str(), file.c_str()) != 0) {
        const int cause = errno;
        std::error_code ignored;
        std::filesystem::remove(partial, ignored);
        throw std::runtime_error("report: cannot write " + file.string() + ": " +
                                 std::strerror(cause));
    }
}

} // namespace autostereo::daemon
