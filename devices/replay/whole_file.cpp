#include "devices/replay/whole_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>

namespace autostereo::devices {

void writeWhole(const std::filesystem::path& path, std::string_view bytes, std::string_view who) {
    std::error_code nothing; // is there
    if (std::filesystem::exists(path, nothing) && !std::filesystem::is_regular_file(path, nothing))
        throw std::runtime_error(std::string(who) + "cannot write " + path.string() +
                                 ": it is there and no plain file");
    const std::string temporary = path.string() + "." + std::to_string(::getpid()) + ".part";
    std::ofstream out(temporary, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    std::error_code error;
    if (out) std::filesystem::rename(temporary, path, error);
    if (out && !error) return;
    if (!error) error = std::error_code(errno, std::generic_category());
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw std::runtime_error(std::string(who) + "cannot write " + path.string() + ": " +
                             error.message());
}

void replaceKeepingOld(const std::filesystem::path& path, std::string_view bytes,
                       std::string_view who) {
    if (std::ifstream old(path, std::ios::binary); old) {
        const std::string kept{std::istreambuf_iterator<char>(old), {}};
        writeWhole(path.string() + ".old", kept, who);
    }
    writeWhole(path, bytes, who);
}

} // namespace autostereo::devices
