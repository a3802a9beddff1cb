#pragma once

#include "gpu/readback.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

namespace autostereo::bench {

/// CPU time of all threads of the process so far: on llvmpipe the GPU's work is in it.
inline double cpuMs() {
    std::timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

inline double median(std::vector<double> times) {
    std::ranges::sort(times);
    return times[times.size() / 2];
}

inline double psnrDb(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        squares += std::pow(static_cast<double>(a[i]) - b[i], 2);
    return 10 * std::log10(255 * 255 * static_cast<double>(a.size()) / std::max(squares, 1e-9));
}

} // namespace autostereo::bench
