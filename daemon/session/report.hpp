#pragma once

#include "daemon/session/histogram.hpp"
#include "daemon/session/percentiles.hpp"
#include "devices/feed.hpp"
#include "devices/record/recorder.hpp"

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace autostereo::daemon {

/// A picture's way from mid-exposure to the panel, milliseconds; the parts of one picture add up to
/// its latency.
struct LatencyParts {
    Percentiles transfer; ///< until its depth frame was here: half the exposure, the camera's way
    Percentiles pairing;  ///< until its colour frame was here, too
    Percentiles wait;     ///< for a nearer colour frame, for the picture before
    Percentiles draw;     ///< until the GPU had filled the panel
    Percentiles swap;     ///< until it was presented
};

/// The accounts of a run. frames_in = presented + skipped + dropped holds between frames.
struct Report {
    std::string input;
    std::string display;
    std::string renderer;
    devices::FeedCounters feed;
    std::uint64_t presented = 0;
    std::map<std::string, std::uint64_t> skipped; ///< why -> pairs that needed no drawing
    std::uint64_t withoutDepth = 0; ///< presented pairs whose depth frame measures nothing
    std::vector<std::string> stageNames;
    std::vector<Percentiles> stageMs;
    /// What became of depth pixels -> pixels per frame.
    std::vector<std::pair<std::string, double>> conditioner;
    std::string method; ///< that shows it, as in configurations
    /// Where the scene was put last, and how much of the panel that clamps.
    struct Depth {
        double focusM = 0;
        double scale = 0;                   ///< relative to the natural one
        std::optional<double> clampedShare; ///< none: not followed, not measured
    };
    std::optional<Depth> depth;                           ///< none before the first frame
    std::optional<devices::Recorder::Counters> recording; ///< none: nothing is recorded
    std::optional<double> keptShare; ///< of the panel, not searched anew; none: not searched at all
    std::optional<double> keptPicture; ///< of the panel, not drawn anew
    std::optional<double> keptFusion;  ///< of the cyclopean picture, not fused anew
    double keptColor = 0;              ///< of the colour camera's picture, taken for noise
    std::string colorWay = "copied";   ///< how the newest colour picture came to the GPU
    double gpuMemoryMib = 0;           ///< textures and buffers of all stages
    std::int64_t gpuObjects = 0;       ///< textures, buffers, programs, queries, ...
    Percentiles latencyMs;             ///< mid-exposure to present; empty at --speed max
    Histogram latencyHistogram;        ///< of the same, all of them
    LatencyParts latencyParts;         ///< what it is made of, one after the other
    double seconds = 0;

    [[nodiscard]] std::uint64_t skippedTotal() const;
    /// One line for people.
    [[nodiscard]] std::string summary() const;
};

/// A JSON object, two spaces a level.
[[nodiscard]] std::string reportText(const Report& report);
/// The same, written beside the file and moved over it, so that a reader never sees half. Throws
/// std::runtime_error.
void writeReport(const Report& report, const std::filesystem::path& file);

} // namespace autostereo::daemon
