#include "gpu/depth_statistics.hpp"

#include "gpu/gl/dispatch.hpp"

#include <span>

namespace autostereo::gpu {

DepthStatistics::DepthStatistics() : program_({"depth_statistics.comp"}) {}

void DepthStatistics::measure(const gl::Texture& points) {
    bins_.begin(1);
    glBindTextureUnit(0, points.name());
    gl::dispatch(program_, points.width(), points.height());
    bins_.end();
}

std::optional<DepthStatistics::Depths> DepthStatistics::take() {
    if (bins_.pending() <= kLatency) return std::nullopt;
    return takeOldest();
}

std::optional<DepthStatistics::Depths> DepthStatistics::takeNewest() {
    std::optional<Depths> newest;
    while (bins_.pending() > 0)
        newest = takeOldest();
    return newest;
}

DepthStatistics::Depths DepthStatistics::takeOldest() {
    const std::vector<std::uint32_t> counts = bins_.waitForOldest();
    const std::span all(counts);
    return {calib::DepthHistogram(all.first(calib::DepthHistogram::kBins)),
            calib::DepthHistogram(all.last(calib::DepthHistogram::kBins))};
}

} // namespace autostereo::gpu
