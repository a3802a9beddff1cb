#include "config/text_file.hpp"

#include "config/embedded_files.hpp"
#include "config/load.hpp"
#include "config/phrases.hpp"

#include <cerrno>
#include <cstddef>
#include <fstream>
#include <system_error>

namespace autostereo::config {

std::string readTextFile(const std::filesystem::path& file) {
    constexpr std::size_t kLongest = 1 << 20;
    const auto unreadable = [&file](const std::string& why) {
        return ConfigError(oneLine(file.string() + ": cannot be read: " + why));
    };
    errno = 0;
    std::ifstream in(file, std::ios::binary);
    std::string text(kLongest + 1, '\0');
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!in.is_open() || in.bad() || std::filesystem::is_directory(file))
        throw unreadable(std::generic_category().message(errno));
    text.resize(static_cast<std::size_t>(in.gcount()));
    if (text.size() > kLongest) throw unreadable("it is longer than 1 MiB");
    return text;
}

std::string_view embeddedText(std::string_view name) {
    for (const EmbeddedFile& file : embeddedFiles())
        if (file.name == name) return file.text;
    return {};
}

std::vector<std::string> embeddedNames(std::string_view prefix) {
    std::vector<std::string> names;
    for (const EmbeddedFile& file : embeddedFiles())
        if (file.name.starts_with(prefix)) names.emplace_back(file.name);
    return names;
}

} // namespace autostereo::config
