#include "daemon/session/metrics.hpp"

#include "daemon/session/show_policy.hpp"

#include <charconv>
#include <chrono>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <utility>

#include <unistd.h>

namespace autostereo::daemon {

namespace {

using Labels = std::initializer_list<std::pair<const char*, std::string>>;

std::string number(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}
std::string number(std::uint64_t value) { return std::to_string(value); }

std::string escaped(const std::string& value) {
    std::string text;
    for (const char letter : value) {
        if (letter == '\\' || letter == '"') text += '\\';
        if (letter == '\n')
            text += "\\n";
        else
            text += letter;
    }
    return text;
}

/// Families one after the other, each with its samples.
class Exposition {
  public:
    void family(const std::string& name, const char* type, const char* help) {
        name_ = name;
        text_ += "# HELP " + name + ' ' + help + "\n# TYPE " + name + ' ' + type + '\n';
    }
    template<class Number>
    void sample(Number value, Labels labels = {}, const char* suffix = "") {
        text_ += name_ + suffix;
        const char* separator = "{";
        for (const auto& [label, text] : labels) {
            text_ += separator + std::string(label) + "=\"" + escaped(text) + '"';
            separator = ",";
        }
        text_ += (labels.size() > 0 ? "} " : " ") + number(value) + '\n';
    }
    /// A family of one sample.
    template<class Number>
    void single(const std::string& name, const char* type, const char* help, Number value) {
        family(name, type, help);
        sample(value);
    }
    [[nodiscard]] std::string take() { return std::move(text_); }

  private:
    std::string name_, text_;
};

double seconds(devices::Duration duration) {
    return std::chrono::duration<double>(duration).count();
}

void writeStreams(Exposition& to, const devices::FeedCounters& feed) {
    const auto both = [&](const char* name, const char* help, auto member) {
        to.family(name, "counter", help);
        to.sample(feed.depth.*member, {{"stream", "depth"}});
        to.sample(feed.color.*member, {{"stream", "color"}});
    };
    using Stream = devices::StreamCounters;
    both("autostereo_stream_frames_total", "Frames that a camera gave.", &Stream::in);
    both("autostereo_stream_unpaired_total", "Frames without a partner in time.",
         &Stream::unpaired);
    both("autostereo_stream_damaged_total", "Frames that could not be read.", &Stream::damaged);
    both("autostereo_stream_reconnects_total", "Times a camera was opened again.",
         &Stream::reconnects);
}

void writeFrames(Exposition& to, const Report& report) {
    to.single("autostereo_pairs_total", "counter", "Pairs of depth and colour.", report.feed.pairs);
    to.single("autostereo_frames_presented_total", "counter", "Pairs drawn and shown.",
              report.presented);
    to.single("autostereo_frames_dropped_total", "counter", "Pairs that a newer one overtook.",
              report.feed.dropped);
    to.family("autostereo_frames_skipped_total", "counter", "Pairs not drawn, by reason.");
    for (const auto& [reason, count] : report.skipped)
        to.sample(count, {{"reason", reason}});
    to.single("autostereo_frames_without_depth_total", "counter",
              "Pairs shown whose depth measured nothing.", report.withoutDepth);
    if (!report.recording) return;
    to.single("autostereo_recording_frames_total", "counter", "Frames written to the recording.",
              report.recording->written);
    to.single("autostereo_recording_left_out_total", "counter",
              "Frames that the recording has no room or time for.", report.recording->leftOut);
}

void writeSensors(Exposition& to, const Status& status) {
    if (!status.sensors) return;
    using devices::SensorState;
    const std::pair<const char*, const devices::SensorStatus*> both[] = {
        {"depth", &status.sensors->depth}, {"color", &status.sensors->color}};
    to.family("autostereo_sensor_state", "gauge", "1 for the state that a camera is in.");
    for (const auto& [name, sensor] : both)
        for (const auto state :
             {SensorState::Starting, SensorState::Streaming, SensorState::Lost, SensorState::Ended})
            to.sample(std::uint64_t{sensor->state == state},
                      {{"sensor", name}, {"state", sensorStateName(state)}});
    to.family("autostereo_sensor_last_frame_seconds", "gauge", "Since a camera's last frame.");
    for (const auto& [name, sensor] : both)
        if (sensor->lastFrame)
            to.sample(seconds(status.now - *sensor->lastFrame), {{"sensor", name}});
}

void writeShown(Exposition& to, const Status& status) {
    to.family("autostereo_shown", "gauge", "1 for what the panel shows.");
    for (const auto shown : {Shown::Starting, Shown::Live, Shown::Frozen, Shown::ColorAlone,
                             Shown::Idle, Shown::Nobody, Shown::Closed})
        to.sample(std::uint64_t{status.shown == shownName(shown)}, {{"state", shownName(shown)}});
    to.sample(std::uint64_t{status.shown == "pattern"}, {{"state", "pattern"}});
    to.single("autostereo_picture_age_seconds", "gauge", "Since the panel was filled last.",
              status.pictureAgeS);
    to.single("autostereo_pictures_per_second", "gauge", "Live pictures, lately.", status.rate);
}

void writeLatency(Exposition& to, const Histogram& latency) {
    to.family("autostereo_latency_seconds", "histogram", "From mid-exposure to present.");
    std::uint64_t upTo = 0;
    for (std::size_t i = 0; i < Histogram::kUpToMs.size(); ++i) {
        upTo += latency.counts()[i];
        to.sample(upTo, {{"le", number(Histogram::kUpToMs[i] / 1e3)}}, "_bucket");
    }
    upTo += latency.counts().back();
    to.sample(upTo, {{"le", "+Inf"}}, "_bucket");
    to.sample(latency.sumMs() / 1e3, {}, "_sum");
    to.sample(upTo, {}, "_count");
}

void writeStages(Exposition& to, const Report& report) {
    to.family("autostereo_stage_median_seconds", "gauge", "GPU time of a stage, lately.");
    for (std::size_t i = 0; i < report.stageNames.size(); ++i)
        if (const auto ms = report.stageMs[i].at(0.5))
            to.sample(*ms / 1e3, {{"stage", report.stageNames[i]}});
    to.single("autostereo_gpu_memory_bytes", "gauge", "Textures and buffers of all stages.",
              report.gpuMemoryMib * 1024 * 1024);
    to.single("autostereo_gpu_objects", "gauge", "Textures, buffers, programs and the like.",
              static_cast<double>(report.gpuObjects));
}

void writeHttp(Exposition& to, const Status& status) {
    if (!status.httpRefused) return;
    to.family("autostereo_http_refused_total", "counter", "HTTP requests refused, by status.");
    for (const auto& [code, count] : *status.httpRefused)
        to.sample(count, {{"status", std::to_string(code)}});
}

} // namespace

std::string metricsText(const Status& status, const Report& report, std::uint64_t residentBytes) {
    Exposition to;
    to.family("autostereo_info", "gauge", "What runs here; always 1.");
    to.sample(std::uint64_t{1}, {{"version", AUTOSTEREO_VERSION},
                                 {"display", report.display},
                                 {"renderer", report.renderer},
                                 {"method", report.method}});
    to.single("autostereo_uptime_seconds", "gauge", "Since the first picture was asked for.",
              report.seconds);
    if (residentBytes > 0)
        to.single("process_resident_memory_bytes", "gauge", "Resident memory size in bytes.",
                  residentBytes);
    writeShown(to, status);
    writeStreams(to, report.feed);
    writeSensors(to, status);
    writeFrames(to, report);
    writeLatency(to, report.latencyHistogram);
    writeStages(to, report);
    writeHttp(to, status);
    return to.take();
}

std::uint64_t residentMemory() {
    std::ifstream statm("/proc/self/statm");
    std::uint64_t all = 0, resident = 0;
    if (!(statm >> all >> resident)) return 0;
    return resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

} // namespace autostereo::daemon
