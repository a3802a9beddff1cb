#include "devices/tracking/eye_source.hpp"
#include "devices/tracking/opentrack_packet.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <cmath>

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own entry

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto head = devices::parseOpentrack(fuzz::bytesOf(data, size));
    fuzz::require(!head || size == devices::kOpentrackBytes, "a head of a wrong size");
    if (!head) return 0;
    const auto eyes = devices::eyesOf(*head, {}, {0, 0, 0.65}, 0.063);
    for (const glm::dvec3& eye : {eyes.left, eyes.right})
        fuzz::require(std::isfinite(eye.x) && std::isfinite(eye.y) && std::isfinite(eye.z),
                      "eyes that are nowhere");
    fuzz::require(devices::isPlausible(devices::clamped(eyes)), "no plausible place beside it");
    return 0;
}
