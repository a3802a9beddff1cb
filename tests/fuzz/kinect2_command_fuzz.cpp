#include "devices/kinect2/command.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own entry

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = fuzz::bytesOf(data, size);
    if (const auto problem = devices::kinect2::problemWithCompletion(bytes, 7))
        fuzz::requirePlain(*problem);
    fuzz::requirePlain(devices::kinect2::firmwareVersion(bytes));
    fuzz::require(devices::kinect2::serialNumber(bytes).size() <=
                      devices::kinect2::kSerialBytes / 2,
                  "a serial number longer than its page");
    fuzz::require(size >= 4 || !devices::kinect2::isReady(bytes), "ready without a status");
    return 0;
}
