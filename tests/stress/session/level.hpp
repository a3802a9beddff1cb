#pragma once

#include "gpu/gl/usage.hpp"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <malloc.h>
#include <unistd.h>

namespace autostereo::test {

/// What the process holds. What is free again but kept by the allocator is given back first.
struct Level {
    double residentMib = 0;
    std::ptrdiff_t descriptors = 0, threads = 0;
    gpu::gl::Usage gpu;
};

inline Level levelNow() {
    const auto entries = [](const char* folder) {
        return std::distance(std::filesystem::directory_iterator(folder), {});
    };
    ::malloc_trim(0);
    std::int64_t whole = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> whole >> resident;
    constexpr double kMib = 1024 * 1024;
    return {static_cast<double>(resident * ::sysconf(_SC_PAGESIZE)) / kMib,
            entries("/proc/self/fd"), entries("/proc/self/task"), gpu::gl::usage()};
}

} // namespace autostereo::test
