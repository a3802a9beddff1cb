#include "devices/replay/npy_file.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <stdexcept>

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own entry

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) try {
    const auto array = devices::parseNpy("x.npy", fuzz::bytesOf(data, size));
    fuzz::require(array.data.size() == array.header.bytes() && array.data.size() <= size,
                  "an array of another size than its header's");
    return 0;
} catch (const std::runtime_error& error) {
    static_cast<void>(error); // names what it holds: config makes it one line
    return 0;
}
