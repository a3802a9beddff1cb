#include "devices/display/looking_glass_hid.hpp"
#include "devices/input.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own entry

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) try {
    const std::string text = devices::calibrationFromReplies(fuzz::bytesOf(data, size));
    fuzz::require(!text.empty() && text.size() <= size, "more text than there were replies");
    return 0;
} catch (const devices::DeviceError& error) {
    fuzz::requirePlain(error.what());
    return 0;
}
