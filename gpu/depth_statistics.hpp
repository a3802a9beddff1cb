#pragma once

#include "calib/depth_histogram.hpp"
#include "gpu/gl/counter_ring.hpp"
#include "gpu/gl/program.hpp"

#include <optional>

namespace autostereo::gpu {

/// The mesh's nodes -> how deep what the panel shows is, read back a fixed number of frames later,
/// so that the GPU is not waited for and replays repeat. Thread-bound.
class DepthStatistics {
  public:
    struct Depths {
        calib::DepthHistogram panel;
        calib::DepthHistogram centre; ///< its central third in both directions
    };

    /// Throws GlError.
    DepthStatistics();

    /// `points`: of DepthMesh's layer.
    void measure(const gl::Texture& points);
    /// Those of the frame kLatency frames before the last one measured; none before there is one.
    [[nodiscard]] std::optional<Depths> take();
    /// Those of the last frame measured: waits for the GPU. None without one.
    [[nodiscard]] std::optional<Depths> takeNewest();

  private:
    static constexpr std::size_t kLatency = 2;
    [[nodiscard]] Depths takeOldest();

    gl::Program program_;
    gl::CounterRing bins_{2 * calib::DepthHistogram::kBins};
};

} // namespace autostereo::gpu
