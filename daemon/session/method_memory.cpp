#include "daemon/session/method_memory.hpp"

#include "gpu/panel.hpp"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <functional>

namespace autostereo::daemon {

namespace {

/// A file name's worth of everything that the choice depends on.
std::string keyOf(const gpu::PipelineParams& params, const calib::DisplayProfile& display,
                  int panelWidth, int panelHeight, const calib::SensorRig& rig) {
    const std::string all =
        gpu::rendererName() + '\n' + display.name + '\n' + std::to_string(display.views) + '\n' +
        std::to_string(panelWidth) + 'x' + std::to_string(panelHeight) + '\n' +
        std::to_string(rig.depth.intrinsics.width) + 'x' +
        std::to_string(rig.depth.intrinsics.height) + '\n' + std::to_string(params.fusion.density) +
        '\n' + std::to_string(params.fusion.mostTexels) + '\n' +
        std::to_string(params.synthesis.leastDb) + '\n' +
        std::to_string(params.synthesis.tileScale) + '\n' +
        std::to_string(params.synthesis.viewsPerPass) + '\n' +
        std::to_string(params.synthesis.references);
    char hash[20];
    std::snprintf(hash, sizeof hash, "%016zx", std::hash<std::string>{}(all));
    return "method " + display.name.substr(0, 32) + " " + hash;
}

} // namespace

MethodMemory::MethodMemory(const std::filesystem::path& folder, const gpu::PipelineParams& params,
                           const calib::DisplayProfile& display, int panelWidth, int panelHeight,
                           const calib::SensorRig& rig)
    : files_(folder / "methods"), key_(keyOf(params, display, panelWidth, panelHeight, rig)) {}

gpu::PipelineParams MethodMemory::apply(gpu::PipelineParams params) const {
    if (params.synthesis.method != gpu::Method::Auto) return params;
    const auto text = files_.load(key_);
    if (!text) return params;
    const auto kept = nlohmann::json::parse(*text, nullptr, false);
    if (!kept.is_object() || !kept.contains("method") || !kept["method"].is_string()) return params;
    for (const auto& [name, method] : gpu::kMethods)
        if (kept["method"].get<std::string>() == name) params.synthesis.method = method;
    return params;
}

std::optional<std::string> MethodMemory::keep(const gpu::MethodChoice& choice) const {
    auto trials = nlohmann::json::array();
    for (const gpu::MethodTrial& trial : choice.trials)
        trials.push_back({{"method", gpu::methodName(trial.method)},
                          {"ms", trial.milliseconds},
                          {"psnr_db", trial.psnrDb}});
    const nlohmann::json text{{"method", gpu::methodName(choice.method)}, {"trials", trials}};
    return files_.store(key_, text.dump(2) + '\n');
}

} // namespace autostereo::daemon
