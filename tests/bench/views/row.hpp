#pragma once

#include <string>
#include <vector>

namespace autostereo::bench {

/// One contender in one configuration. Times are medians in one process, in interleaved order, of
/// everything between the fused scene and the full panel; errors are against the search in double
/// precision of the same layers.
struct Row {
    std::string suite, scene, display, grid;
    int views = 0;
    std::string method;
    double wallMs = 0;
    double cpuMs = 0; ///< of the whole process
    double gpuMs = 0;
    double psnrDb = 0;
    double ssim = 0;
    double errMax = 0;           ///< levels
    double badPct = 0;           ///< sub-pixels more than 16 levels off
    double memMib = 0;           ///< textures and buffers of the method alone
    double ratioToMultipass = 0; ///< its CPU time / this one's
};

struct Request {
    std::string suite = "quick"; ///< or "full"
    std::string display;         ///< "": those of the suite
    std::string input;           ///< "": the suite's scenes; else the first picture of this one
};

/// Needs no context; makes its own. `progress` is told each case. Throws GlError, DeviceError,
/// std::invalid_argument for an unknown suite.
[[nodiscard]] std::vector<Row> run(const Request& request, void (*progress)(const std::string&));

[[nodiscard]] std::string json(const std::vector<Row>& rows);
[[nodiscard]] std::string markdown(const std::vector<Row>& rows);
/// The time-error plane of one scene, display and grid as an SVG picture.
[[nodiscard]] std::string plot(const std::vector<Row>& rows);

} // namespace autostereo::bench
