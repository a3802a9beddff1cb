#include "gpu/pipeline.hpp"

namespace autostereo::gpu {

Pipeline::Pipeline(const PipelineParams& params, const calib::SensorRig& rig,
                   const calib::DisplayProfile& display, int panelWidth, int panelHeight)
    : params_(params), rig_(rig), display_(display),
      panelAspect_(static_cast<double>(panelWidth) / panelHeight),
      conditioner_(params.condition, params.mesh, rig.depth), mesh_(params.mesh, rig),
      fusion_(params, rig), views_(makeViewSynthesis(params, display, panelWidth, panelHeight)) {}

template<class Pass>
void Pipeline::timed(std::size_t stage, Pass pass) {
    timers_[stage].begin();
    pass();
    const auto milliseconds = timers_[stage].end();
    if (milliseconds && stageTime_) stageTime_(stage, *milliseconds);
}

void Pipeline::prepare(const devices::RgbdFrame& frame) {
    if (!placed_) placeScene(frame.depth);
    timed(0, [&] { uploader_.upload(frame); });
    const double unitM = frame.depth.metadata().depthUnitM;
    timed(1, [&] { conditioner_.condition(uploader_.depth(), uploader_.amplitude(), unitM); });
    timed(2, [&] { mesh_.build(conditioner_.depth(), unitM, geometry_); });
    timed(3, [&] { fusion_.fuse(mesh_.layer(), uploader_.color(), geometry_); });
    timed(4, [&] { views_->prepare(scene()); });
}

void Pipeline::render(const devices::RgbdFrame& frame, GLuint panel) {
    prepare(frame);
    timed(5, [&] { views_->show(scene(), panel); });
}

void Pipeline::placeScene(const devices::Frame& depth) {
    constexpr double kFocusWithoutDepthM = 1;
    const auto focus =
        params_.budget.focusM ? params_.budget.focusM : medianDepth(depth, rig_, params_.mesh);
    placed_ = focus.has_value();
    geometry_ =
        sceneGeometry(rig_, display_, params_, panelAspect_, focus.value_or(kFocusWithoutDepthM));
}

} // namespace autostereo::gpu
