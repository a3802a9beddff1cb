#pragma once

#include "calib/camera_model.hpp"
#include "gpu/blocks.hpp"
#include "gpu/dirty/block_lister.hpp"
#include "gpu/gl/counter_ring.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/gl/uniform_buffer.hpp"
#include "gpu/params.hpp"

#include <array>
#include <cstdint>
#include <string>

namespace autostereo::gpu {

/// Raw depth counts and IR amplitudes -> clean counts on the same grid (R16UI, 0: no measurement):
/// what is no measurement goes, flying pixels go, pixels where nothing moves are held, small holes
/// are closed. Whole numbers throughout. Remembers one state a pixel, from frame to frame of one
/// size and unit; any other starts anew. Thread-bound.
class DepthConditioner {
  public:
    /// What becomes of pixels, in the order of shaders/condition_tally.glsl; the last is what is
    /// left of all of them.
    static constexpr std::array<const char*, 12> kTallies{
        "missing", "rejected",  "doubtful", "flying", "settling", "passed",
        "mixed",   "corrected", "kept",     "filled", "holes",    "held"};
    struct Tally {
        std::uint64_t frames = 0;                            ///< counted so far, some frames late
        std::array<std::uint64_t, kTallies.size()> pixels{}; ///< in all of them
    };

    /// Throws GlError. Counts outside `range` are no measurement.
    DepthConditioner(const ConditionParams& params, const DepthMeshParams& range,
                     const calib::CameraModel& depthCamera);

    /// `amplitude` is of the depth's size, or null.
    void condition(const gl::Texture& depth, const gl::Texture* amplitude, double depthUnitM);
    [[nodiscard]] const gl::Texture& depth() const { return clean_; }
    /// Blocks of it that differ from the last frame's.
    [[nodiscard]] const BlockMarks& changed() const { return changed_; }
    [[nodiscard]] const Tally& tally() const { return tally_; }
    /// So many like frames in a row, and one more changes nothing: what was before is forgotten.
    [[nodiscard]] std::uint64_t restsAfter() const;

  private:
    void restart(const gl::Texture& depth, double depthUnitM);
    void setBlock(const gl::Texture* amplitude);
    void measure(const gl::Texture& depth, const gl::Texture* amplitude);
    void markFlying(bool again);
    void hold();
    void fillHoles(const gl::Texture& measured, bool everything);
    void takeTally();

    ConditionParams params_;
    DepthMeshParams range_;
    calib::CameraModel camera_;
    double depthUnitM_ = 0;

    gl::Program measure_, flying_, hold_, holes_, resetFills_, sumFills_;
    BlockLister lister_;
    BlockList list_;
    BlockMarks flyingMarks_, calmMarks_;
    gl::Buffer fills_; ///< pixels of each block that were filled, and that were not
    gl::UniformBuffer<ConditionBlock> uniforms_;
    ConditionBlock block_;
    gl::CounterRing counters_{kTallies.size() - 1};
    Tally tally_;

    gl::Texture sigmas_, noAmplitude_;
    gl::Texture pixels_, nextPixels_; ///< from pass to pass
    gl::Texture state_, nextState_;   ///< from frame to frame
    gl::Texture waited_;
    gl::Texture calm_; ///< what is held
    gl::Texture clean_;
    BlockMarks changed_;
    bool restarted_ = true;
};

} // namespace autostereo::gpu
