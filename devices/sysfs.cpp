#include "devices/sysfs.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>

namespace autostereo::devices {

std::string sysfsLine(const std::filesystem::path& file) {
    constexpr std::size_t kLongest = 256;
    std::ifstream stream(file);
    std::string text;
    std::getline(stream, text);
    text.resize(std::min(text.size(), kLongest));
    std::ranges::replace_if(
        text, [](char c) { return static_cast<unsigned char>(c) < ' '; }, '?');
    return text;
}

int leadingNumber(const std::string& text) {
    int value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

std::optional<int> usbMemoryMib(const std::filesystem::path& root) {
    std::ifstream file(root / "sys/module/usbcore/parameters/usbfs_memory_mb");
    int mebibytes = 0;
    if (!(file >> mebibytes)) return std::nullopt;
    return mebibytes;
}

} // namespace autostereo::devices
