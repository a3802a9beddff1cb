#include "devices/input.hpp"
#include "devices/tracking/eye_source.hpp"
#include "devices/tracking/eye_trace.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own entry

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) try {
    const auto trace = devices::parseEyeTrace(fuzz::textOf(data, size), "trace");
    fuzz::require(!trace.empty(), "a trace of nothing");
    for (std::size_t i = 0; i < trace.size(); ++i) {
        fuzz::require(devices::isPlausible(trace[i].eyes), "eyes where nobody is");
        fuzz::require(i == 0 || trace[i].at > trace[i - 1].at, "time runs backwards");
    }
    return 0;
} catch (const devices::DeviceError& error) {
    fuzz::requirePlain(error.what());
    return 0;
}
