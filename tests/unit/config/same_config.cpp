#include "tests/unit/config/same_config.hpp"

#include <gtest/gtest.h>

namespace autostereo::config {

namespace {

void expectSame(const gpu::ConditionParams& a, const gpu::ConditionParams& b) {
    EXPECT_EQ(a.validity, b.validity);
    EXPECT_EQ(a.weakestAmplitude, b.weakestAmplitude);
    EXPECT_EQ(a.saturatedAmplitude, b.saturatedAmplitude);
    EXPECT_EQ(a.confidence, b.confidence);
    EXPECT_DOUBLE_EQ(a.noise.floorM, b.noise.floorM);
    EXPECT_DOUBLE_EQ(a.noise.shotM, b.noise.shotM);
    EXPECT_DOUBLE_EQ(a.noise.growthPerM, b.noise.growthPerM);
    EXPECT_EQ(a.flyingPixels, b.flyingPixels);
    EXPECT_DOUBLE_EQ(a.grazingRad, b.grazingRad);
    EXPECT_EQ(a.edgeSigmas, b.edgeSigmas);
    EXPECT_EQ(a.hold, b.hold);
    EXPECT_EQ(a.gateSigmas, b.gateSigmas);
    EXPECT_EQ(a.settleFrames, b.settleFrames);
    EXPECT_EQ(a.keepFrames, b.keepFrames);
    EXPECT_EQ(a.fillHoles, b.fillHoles);
    EXPECT_EQ(a.holeWidth, b.holeWidth);
}

void expectSame(const gpu::DepthBudgetParams& a, const gpu::DepthBudgetParams& b) {
    EXPECT_EQ(a.focusM, b.focusM);
    EXPECT_EQ(a.depthScale, b.depthScale);
    EXPECT_EQ(a.limits.nearestFocusM, b.limits.nearestFocusM);
    EXPECT_EQ(a.limits.farthestFocusM, b.limits.farthestFocusM);
    EXPECT_EQ(a.limits.leastScale, b.limits.leastScale);
    EXPECT_EQ(a.limits.mostScale, b.limits.mostScale);
    EXPECT_EQ(a.motion.timeConstantS, b.motion.timeConstantS);
    EXPECT_EQ(a.motion.deadBand, b.motion.deadBand);
    EXPECT_DOUBLE_EQ(a.nearShare, b.nearShare);
    EXPECT_DOUBLE_EQ(a.farShare, b.farShare);
    EXPECT_DOUBLE_EQ(a.subjectShare, b.subjectShare);
}

void expectSame(const devices::ViewerParams& a, const devices::ViewerParams& b) {
    EXPECT_EQ(a.source, b.source);
    EXPECT_EQ(a.delay, b.delay);
    EXPECT_DOUBLE_EQ(a.spacingM, b.spacingM);
    EXPECT_EQ(a.smoothing.cutoffHz, b.smoothing.cutoffHz);
    EXPECT_EQ(a.smoothing.cutoffPerSpeed, b.smoothing.cutoffPerSpeed);
    EXPECT_EQ(a.smoothing.velocityCutoffHz, b.smoothing.velocityCutoffHz);
    EXPECT_EQ(a.smoothing.restSpeed, b.smoothing.restSpeed);
    EXPECT_EQ(a.lostAfter, b.lostAfter);
    EXPECT_EQ(a.ease, b.ease);
    EXPECT_EQ(a.pose.originM, b.pose.originM);
    EXPECT_EQ(a.pose.rotationRad, b.pose.rotationRad);
    EXPECT_EQ(a.pose.scale, b.pose.scale);
    EXPECT_EQ(a.pose.angleScale, b.pose.angleScale);
}

void expectSameService(const Config& a, const Config& b) {
    EXPECT_EQ(a.wait, b.wait);
    EXPECT_EQ(a.brightness, b.brightness);
    EXPECT_EQ(a.flat, b.flat);
    EXPECT_EQ(a.control.socket, b.control.socket);
    EXPECT_EQ(a.control.group, b.control.group);
    EXPECT_EQ(a.ring, b.ring);
    EXPECT_EQ(a.http, b.http);
    EXPECT_EQ(a.idle.freeze, b.idle.freeze);
    EXPECT_EQ(a.idle.content, b.idle.content);
    EXPECT_EQ(a.idle.startingText, b.idle.startingText);
    EXPECT_EQ(a.idle.noInputText, b.idle.noInputText);
    EXPECT_EQ(a.idle.depthLostText, b.idle.depthLostText);
    EXPECT_EQ(a.idle.colorLostText, b.idle.colorLostText);
    EXPECT_EQ(a.idle.bothLostText, b.idle.bothLostText);
    EXPECT_EQ(a.idle.noPairsText, b.idle.noPairsText);
    EXPECT_EQ(a.rest.hours, b.rest.hours);
    EXPECT_EQ(a.rest.presenceM, b.rest.presenceM);
    EXPECT_EQ(a.rest.presenceShare, b.rest.presenceShare);
    EXPECT_EQ(a.rest.leave, b.rest.leave);
    EXPECT_EQ(a.rest.monitorOff, b.rest.monitorOff);
}

} // namespace

void expectSame(const Config& a, const Config& b) {
    expectSame(a.pipeline.condition, b.pipeline.condition);
    expectSame(a.viewer, b.viewer);
    EXPECT_EQ(a.input, b.input);
    EXPECT_EQ(a.color, b.color);
    EXPECT_EQ(a.display, b.display);
    EXPECT_EQ(a.rig, b.rig);
    EXPECT_EQ(a.output, b.output);
    EXPECT_EQ(a.refreshHz, b.refreshHz);
    EXPECT_EQ(a.sync.tolerance, b.sync.tolerance);
    EXPECT_EQ(a.reconnect.firstDelay, b.reconnect.firstDelay);
    EXPECT_EQ(a.reconnect.longestDelay, b.reconnect.longestDelay);
    EXPECT_EQ(a.pipeline.mesh.nearestM, b.pipeline.mesh.nearestM);
    EXPECT_EQ(a.pipeline.mesh.farthestM, b.pipeline.mesh.farthestM);
    EXPECT_EQ(a.pipeline.mesh.cutRatio, b.pipeline.mesh.cutRatio);
    EXPECT_EQ(a.pipeline.registration.extrudePx, b.pipeline.registration.extrudePx);
    EXPECT_EQ(a.depthFollows, b.depthFollows);
    expectSame(a.pipeline.budget, b.pipeline.budget);
    EXPECT_EQ(a.pipeline.framing.quarterTurns, b.pipeline.framing.quarterTurns);
    EXPECT_EQ(a.pipeline.framing.mirror, b.pipeline.framing.mirror);
    EXPECT_EQ(a.pipeline.framing.zoom, b.pipeline.framing.zoom);
    EXPECT_EQ(a.pipeline.framing.pan, b.pipeline.framing.pan);
    EXPECT_EQ(a.pipeline.backdrop.cutM, b.pipeline.backdrop.cutM);
    EXPECT_EQ(a.pipeline.backdrop.width, b.pipeline.backdrop.width);
    EXPECT_EQ(a.pipeline.backdrop.pixels, b.pipeline.backdrop.pixels);
    EXPECT_EQ(a.pipeline.synthesis.method, b.pipeline.synthesis.method);
    EXPECT_EQ(a.pipeline.synthesis.filter, b.pipeline.synthesis.filter);
    EXPECT_EQ(a.pipeline.skipUnchanged, b.pipeline.skipUnchanged);
    EXPECT_EQ(a.pipeline.color.sigma, b.pipeline.color.sigma);
    EXPECT_EQ(a.pipeline.clearColor, b.pipeline.clearColor);
    EXPECT_EQ(a.log.level, b.log.level);
    expectSameService(a, b);
}

} // namespace autostereo::config
