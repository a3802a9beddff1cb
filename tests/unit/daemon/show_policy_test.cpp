#include "daemon/session/show_policy.hpp"

#include <gtest/gtest.h>

#include <chrono>

using namespace std::chrono_literals;

namespace autostereo::daemon {
namespace {

using devices::SensorState;

/// Cameras at 30 frames a second on a clock of the test's own.
struct ShowPolicyTest : testing::Test {
    static devices::TimePoint at(devices::Duration time) { return devices::TimePoint(time); }

    /// A pair that is shown at once, if it may be.
    bool pair(devices::Duration time, devices::Duration age = 0ms) {
        if (!policy.arrived(at(time), at(time - age))) return false;
        policy.presented(at(time));
        return true;
    }
    /// Pairs until `end`; the time of the last.
    devices::Duration pairsUntil(devices::Duration end, devices::Duration period = 33ms) {
        devices::Duration time = 1s;
        for (; time <= end; time += period)
            pair(time);
        return time - period;
    }
    static devices::SensorStatuses sensors(SensorState depth, SensorState color,
                                           devices::Duration lastFrame) {
        return {{depth, at(lastFrame), ""}, {color, at(lastFrame), ""}};
    }
    std::optional<devices::SensorStatuses> good(devices::Duration now) const {
        return sensors(SensorState::Streaming, SensorState::Streaming, now);
    }
    config::IdleParams params; // freezes for 1 s
    ShowPolicy policy{params, at(0s)};
};

TEST_F(ShowPolicyTest, LiveThenFrozenThenIdle) {
    const auto last = pairsUntil(3s);
    const auto shown = [&](devices::Duration later) {
        return policy.decide(at(last + later), good(last));
    };
    EXPECT_EQ(shown(0ms), Shown::Live);
    EXPECT_EQ(shown(200ms), Shown::Live);
    EXPECT_EQ(shown(201ms), Shown::Frozen) << "older than 200 ms is not live";
    EXPECT_EQ(shown(1200ms), Shown::Frozen);
    EXPECT_EQ(shown(1201ms), Shown::Idle);
    EXPECT_TRUE(pair(last + 5s));
    EXPECT_EQ(shown(5s), Shown::Live) << "at once";
}

TEST_F(ShowPolicyTest, SlowCamerasAreNotCalledLate) {
    const auto last = pairsUntil(5s, 500ms);
    EXPECT_EQ(policy.decide(at(last + 1500ms), good(last)), Shown::Live);
    EXPECT_EQ(policy.decide(at(last + 1501ms), good(last)), Shown::Frozen);
    // One long gap is no rate.
    EXPECT_TRUE(pair(last + 100s));
    EXPECT_EQ(policy.decide(at(last + 101500ms), good(last)), Shown::Live);
    EXPECT_EQ(policy.decide(at(last + 101501ms), good(last)), Shown::Frozen);
    // Nor are two: nothing is as slow as that.
    EXPECT_TRUE(pair(last + 200s));
    EXPECT_EQ(policy.decide(at(last + 203s + 1ms), good(last)), Shown::Frozen);
    EXPECT_EQ(policy.decide(at(last + 204s + 1ms), good(last)), Shown::Idle);
}

TEST_F(ShowPolicyTest, DrawingTakesNothingOffTheRate) {
    for (devices::Duration time = 0s; time <= 4s; time += 500ms) {
        EXPECT_TRUE(policy.arrived(at(time), at(time)));
        policy.presented(at(time));
        policy.presented(at(time + 10ms)); // drawn
    }
    EXPECT_EQ(policy.decide(at(5500ms), good(4s)), Shown::Live) << "two frames a second";
}

TEST_F(ShowPolicyTest, WhatACameraHeldBackIsNotLive) {
    const auto last = pairsUntil(3s);
    EXPECT_FALSE(pair(last + 600ms, 500ms));
    EXPECT_FALSE(pair(last + 601ms, 400ms)) << "one gap is no rate";
    EXPECT_EQ(policy.decide(at(last + 602ms), good(last)), Shown::Frozen);
    EXPECT_TRUE(pair(last + 603ms, 150ms));
    EXPECT_EQ(policy.decide(at(last + 653ms), good(last)), Shown::Live);
    EXPECT_EQ(policy.decide(at(last + 654ms), good(last)), Shown::Frozen)
        << "200 ms after it was captured";
}

TEST_F(ShowPolicyTest, DamagedStampsAreOldOrNew) {
    const auto last = pairsUntil(3s);
    EXPECT_FALSE(policy.arrived(at(last + 33ms), devices::TimePoint::min()));
    EXPECT_TRUE(policy.arrived(at(last + 66ms), devices::TimePoint::max()));
    policy.presented(at(last + 66ms));
    EXPECT_EQ(policy.decide(at(last + 267ms), good(last)), Shown::Frozen);
}

TEST_F(ShowPolicyTest, WithoutDepthColourIsShownAloneAfterTheFreeze) {
    const auto last = pairsUntil(3s);
    const auto now = last + 1300ms;
    auto states = sensors(SensorState::Lost, SensorState::Streaming, now);
    EXPECT_TRUE(policy.wantsColor(at(now), states));
    EXPECT_FALSE(policy.wantsColor(at(last + 1100ms), states)) << "still frozen";
    EXPECT_EQ(policy.decide(at(now), states), Shown::Idle) << "before the first colour frame";
    policy.colored(at(now));
    EXPECT_EQ(policy.decide(at(now), states), Shown::ColorAlone);
    EXPECT_EQ(policy.decide(at(now + 201ms), states), Shown::Idle);

    states = sensors(SensorState::Streaming, SensorState::Lost, now);
    EXPECT_FALSE(policy.wantsColor(at(now), states)) << "there is none";
    EXPECT_FALSE(policy.wantsColor(at(now), good(now))) << "both stream: depth may still come";
    EXPECT_FALSE(policy.wantsColor(at(now), std::nullopt));
}

TEST_F(ShowPolicyTest, ASilentSensorIsAsGoodAsALostOne) {
    const auto last = pairsUntil(3s);
    const auto now = last + 1300ms;
    devices::SensorStatuses states = *good(now);
    states.depth.lastFrame = at(last);
    EXPECT_TRUE(policy.wantsColor(at(now), states));
    EXPECT_EQ(policy.message(at(now), states), params.depthLostText);
}

TEST_F(ShowPolicyTest, MessagesNameWhatIsMissing) {
    const devices::Duration now = 9s;
    const auto message = [&](SensorState depth, SensorState color) {
        return policy.message(at(now), sensors(depth, color, now));
    };
    EXPECT_EQ(message(SensorState::Lost, SensorState::Streaming), params.depthLostText);
    EXPECT_EQ(message(SensorState::Streaming, SensorState::Lost), params.colorLostText);
    EXPECT_EQ(message(SensorState::Lost, SensorState::Ended), params.bothLostText);
    EXPECT_EQ(message(SensorState::Starting, SensorState::Starting), params.bothLostText);
    EXPECT_EQ(message(SensorState::Streaming, SensorState::Streaming), params.noPairsText);
    EXPECT_EQ(policy.message(at(1s), std::nullopt), params.startingText);
    EXPECT_EQ(policy.message(at(1001ms), std::nullopt), params.noInputText);
}

TEST_F(ShowPolicyTest, CamerasThatAreOpenGetASecondForTheirFirstPair) {
    const auto states = sensors(SensorState::Starting, SensorState::Starting, 0s);
    EXPECT_EQ(policy.decide(at(500ms), std::nullopt), Shown::Idle) << "nothing is open";
    EXPECT_EQ(policy.decide(at(1s), states), Shown::Starting);
    EXPECT_EQ(policy.decide(at(1001ms), states), Shown::Idle);
    policy.opened(at(20s));
    EXPECT_EQ(policy.decide(at(21s), states), Shown::Starting);
    EXPECT_EQ(policy.decide(at(21s + 1ms), states), Shown::Idle);
}

} // namespace
} // namespace autostereo::daemon
