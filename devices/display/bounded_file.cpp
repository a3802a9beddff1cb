#include "devices/display/bounded_file.hpp"

#include "devices/unique_fd.hpp"

#include <array>
#include <cerrno>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace autostereo::devices {

std::optional<std::string> readBoundedFile(const std::filesystem::path& file,
                                           std::size_t mostBytes) {
    const UniqueFd fd(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    struct stat about {};
    if (!fd || ::fstat(fd.get(), &about) != 0 || !S_ISREG(about.st_mode)) return std::nullopt;
    std::string text;
    std::array<char, 4096> part{};
    for (;;) {
        const ssize_t count = ::read(fd.get(), part.data(), part.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return std::nullopt;
        if (count == 0) return text;
        text.append(part.data(), static_cast<std::size_t>(count));
        if (text.size() > mostBytes) return std::nullopt;
    }
}

} // namespace autostereo::devices
