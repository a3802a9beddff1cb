#include "devices/display/edid.hpp"
#include "tests/fuzz/fuzz.hpp"

#include <vector>

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own entry

namespace {

/// Good checksums, which no mutation would find.
std::vector<std::byte> repaired(std::span<const std::byte> bytes) {
    constexpr std::size_t kBlock = 128;
    std::vector<std::byte> copy(bytes.begin(), bytes.end());
    for (std::size_t end = kBlock; end <= copy.size(); end += kBlock) {
        unsigned sum = 0;
        for (std::size_t i = end - kBlock; i + 1 < end; ++i)
            sum += std::to_integer<unsigned>(copy[i]);
        copy[end - 1] = static_cast<std::byte>(0x100U - sum % 0x100U);
    }
    return copy;
}

void parse(std::span<const std::byte> bytes) {
    const auto result = devices::parseEdid(bytes);
    if (const auto* error = std::get_if<devices::EdidError>(&result)) {
        fuzz::requirePlain(error->text);
        return;
    }
    const auto& edid = std::get<devices::Edid>(result);
    static_cast<void>(devices::isLookingGlass(edid));
    for (const std::string& fault : edid.faults)
        fuzz::requirePlain(fault);
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    parse(fuzz::bytesOf(data, size));
    parse(repaired(fuzz::bytesOf(data, size)));
    return 0;
}
