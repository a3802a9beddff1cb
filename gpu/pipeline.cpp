#include "gpu/pipeline.hpp"

#include <algorithm>

namespace autostereo::gpu {

Pipeline::Pipeline(const PipelineParams& params, const calib::SensorRig& rig,
                   const calib::DisplayProfile& display, int panelWidth, int panelHeight)
    : params_(params), rig_(rig), display_(display), panelWidth_(panelWidth),
      panelHeight_(panelHeight), uploader_(params.color),
      conditioner_(params.condition, params.mesh, rig.depth), mesh_(params.mesh, rig),
      fusion_(params, rig) {
    if (params.synthesis.method != Method::Auto || params.synthesis.followEyes) makeViews();
    if (params.budget.follow) budget_.emplace(params.budget, display);
}

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
    timed(2, [&] { buildMesh(frame.depth.metadata()); });
    const FusionChanges changes{mesh_.redraw(),
                                uploader_.colorChanged() ? &uploader_.colorMarks() : nullptr};
    timed(3, [&] {
        fusion_.fuse(mesh_.layer(), uploader_.color(), geometry_,
                     params_.skipUnchanged ? &changes : nullptr);
    });
    if (!views_) {
        choice_ = chooseMethod(params_, display_, panelWidth_, panelHeight_, scene());
        params_.synthesis.method = choice_->method;
        makeViews();
    }
    timed(4, [&] { views_->prepare(scene()); });
}

void Pipeline::makeViews() {
    views_ = makeViewSynthesis(params_, display_, panelWidth_, panelHeight_);
    if (eyes_) views_->setEyes(*eyes_);
}

void Pipeline::setEyes(const calib::EyePair& eyes) {
    eyes_ = eyes;
    if (views_) views_->setEyes(eyes);
}

void Pipeline::adjust(const DepthBudgetParams& budget, Method method) {
    params_.budget = budget;
    budget_.reset();
    if (budget.follow) budget_.emplace(budget, display_);
    if (placed_) { // the frame stays: only depth moves
        const double focus = budget.focusM.value_or(geometry_.law.focusM);
        geometry_.law = calib::disparityLaw(display_, focus, geometry_.framing.width * focus,
                                            budget.depthScale.value_or(1));
    }
    if (method == params_.synthesis.method) return;
    params_.synthesis.method = method;
    views_.reset();
    choice_.reset();
    if (method != Method::Auto || params_.synthesis.followEyes) makeViews();
}

void Pipeline::buildMesh(const devices::FrameMetadata& depth) {
    if (budget_) budget_->follow(depth.capturedAt, geometry_);
    mesh_.build(conditioner_.depth(), depth.depthUnitM, geometry_,
                params_.skipUnchanged ? &conditioner_.changed() : nullptr);
    if (budget_ && budget_->measure(mesh_.layer().points, geometry_))
        mesh_.build(conditioner_.depth(), depth.depthUnitM, geometry_);
}

void Pipeline::render(const devices::RgbdFrame& frame, GLuint panel) {
    prepare(frame);
    show(panel);
}

void Pipeline::show(GLuint panel) {
    timed(5, [&] { views_->show(scene(), panel); });
}

void Pipeline::placeScene(const devices::Frame& depth) {
    constexpr double kFocusWithoutDepthM = 1;
    const DepthBudgetParams& budget = params_.budget;
    DepthMeshParams shown = params_.mesh;
    if (params_.backdrop.cutM > 0)
        shown.farthestM = std::min(shown.farthestM, params_.backdrop.cutM);
    const auto measured = medianDepth(depth, rig_, shown);
    placed_ = budget.focusM || measured;
    const double chosen = std::clamp(measured.value_or(kFocusWithoutDepthM),
                                     budget.limits.nearestFocusM, budget.limits.farthestFocusM);
    geometry_ =
        sceneGeometry(rig_, display_, params_, static_cast<double>(panelWidth_) / panelHeight_,
                      budget.focusM.value_or(chosen));
}

} // namespace autostereo::gpu
