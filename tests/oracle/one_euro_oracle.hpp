#pragma once

#include <cmath>
#include <vector>

// Slow, obvious twin of the one-euro filter along one line: the low passes written as sums over all
// samples (Casiez, Roussel, Vogel 2012, algorithm 1), in extended precision.

namespace autostereo::oracle {

struct LineSample {
    long double at;    ///< seconds
    long double place; ///< metres
};

struct OneEuroNumbers {
    long double cutoffHz, cutoffPerSpeed, velocityCutoffHz;
};

struct Smoothed {
    long double place = 0;
    long double velocity = 0;
    long double lag = 0; ///< seconds that the place is behind in a steady motion
};

inline long double oneEuroWeight(long double cutoffHz, long double period) {
    const long double tau = 1 / (2 * std::acos(-1.0L) * cutoffHz);
    return 1 / (1 + tau / period);
}

/// Sum of values, each with its weight times what all later weights leave over; the first value
/// fills the rest.
inline long double lowPassed(const std::vector<long double>& values,
                             const std::vector<long double>& weights) {
    long double sum = 0, left = 1;
    for (std::size_t i = values.size(); i-- > 1;) {
        sum += left * weights[i] * values[i];
        left *= 1 - weights[i];
    }
    return sum + left * values[0];
}

inline Smoothed oneEuro(const std::vector<LineSample>& samples, const OneEuroNumbers& numbers) {
    std::vector<long double> places{samples[0].place}, speeds{0}, weights{1}, speedWeights{1};
    Smoothed found{samples[0].place, 0, 0};
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const long double period = samples[i].at - samples[i - 1].at;
        speeds.push_back((samples[i].place - samples[i - 1].place) / period);
        speedWeights.push_back(oneEuroWeight(numbers.velocityCutoffHz, period));
        found.velocity = lowPassed(speeds, speedWeights);
        const long double weight = oneEuroWeight(
            numbers.cutoffHz + numbers.cutoffPerSpeed * std::abs(found.velocity), period);
        places.push_back(samples[i].place);
        weights.push_back(weight);
        found.lag = period / weight - period;
    }
    found.place = lowPassed(places, weights);
    return found;
}

} // namespace autostereo::oracle
