#pragma once

#include "calib/eye_pair.hpp"

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace autostereo::test {

/// Somebody who walks to and fro in front of a panel: 1.2 m straight on at a steady speed, a turn
/// of 0.8 s, back; nearer and farther within 8 cm. The head bobs (15 mm), sways (20 mm) and surges
/// (5 mm) with the steps, looks left and right (10 degrees) and leans (3 degrees).
class Walker {
  public:
    Walker(double speed, double distance) : speed_(speed), distance_(distance) {}

    [[nodiscard]] calib::EyePair at(double seconds) const {
        const double steps = wave(seconds, stepHz_), sway = wave(seconds, stepHz_ / 2);
        const double yaw = 10 * kDegree * wave(seconds, 0.4);
        const double roll = 3 * kDegree * sway;
        const glm::dvec3 middle{along(seconds) + 0.005 * steps, 0.05 + 0.015 * steps,
                                distance_ + 0.08 * wave(seconds, 0.13) + 0.02 * sway};
        const glm::dvec3 half =
            0.03175 * glm::dvec3{std::cos(yaw) * std::cos(roll), -std::sin(roll), std::sin(yaw)};
        return {middle - half, middle + half};
    }

  private:
    static constexpr double kDegree = std::numbers::pi / 180;
    static constexpr double kStraightM = 1.2, kTurnS = 0.8;

    static double wave(double seconds, double hertz) {
        return std::sin(2 * std::numbers::pi * hertz * seconds);
    }
    /// At constant speed over the straight, then at constant deceleration round and back.
    [[nodiscard]] double along(double seconds) const {
        const double straight = kStraightM / speed_, half = straight + kTurnS;
        const double whole = std::floor(seconds / half), s = seconds - whole * half;
        const double turn = s - straight;
        const double way = s < straight ? speed_ * s - kStraightM / 2
                                        : kStraightM / 2 + speed_ * turn * (1 - turn / kTurnS);
        return std::fmod(whole, 2) == 0 ? way : -way;
    }

    double speed_, distance_;
    double stepHz_ = 1.1 + 0.6 * speed_; ///< steps a second
};

/// A tracker's noise, standard deviations, metres: to the sides and in distance.
class TrackerNoise {
  public:
    TrackerNoise(double sideways, double inDistance, std::uint32_t seed)
        : sideways_(sideways), inDistance_(inDistance), engine_(seed) {}
    [[nodiscard]] calib::EyePair on(const calib::EyePair& eyes) {
        return {eyes.left + sample(), eyes.right + sample()};
    }

  private:
    glm::dvec3 sample() {
        return {sideways_ * normal_(engine_), sideways_ * normal_(engine_),
                inDistance_ * normal_(engine_)};
    }

    double sideways_, inDistance_;
    std::mt19937 engine_;
    std::normal_distribution<double> normal_;
};

} // namespace autostereo::test
