#include "devices/v4l2/node_holders.hpp"

#include <unistd.h>

#include <algorithm>
#include <fstream>

namespace autostereo::devices::v4l2 {

namespace {

namespace fs = std::filesystem;

/// Entries of a folder that may go away while they are looked at, a bounded number.
template<class Visit>
void forEach(const fs::path& folder, const Visit& visit) {
    constexpr int kMost = 100'000;
    std::error_code error;
    fs::directory_iterator entry(folder, error);
    for (int i = 0; i < kMost && !error && entry != fs::directory_iterator();
         ++i, entry.increment(error))
        visit(entry->path());
}

bool isNumber(const std::string& text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) { return c >= '0' && c <= '9'; });
}

bool holds(const fs::path& process, const fs::path& node) {
    bool found = false;
    forEach(process / "fd", [&](const fs::path& descriptor) {
        std::error_code error;
        found = found || fs::read_symlink(descriptor, error) == node;
    });
    return found;
}

} // namespace

std::string holdersOf(const fs::path& node, const fs::path& proc) {
    constexpr std::size_t kLongest = 120;
    std::error_code error;
    const fs::path real = fs::canonical(node, error);
    const std::string self = std::to_string(::getpid());
    std::string names;
    forEach(proc, [&](const fs::path& process) {
        const std::string pid = process.filename().string();
        if (!isNumber(pid) || pid == self || names.size() > kLongest) return;
        if (!holds(process, error ? node : real)) return;
        std::string name;
        std::ifstream comm(process / "comm");
        std::getline(comm, name);
        names += (names.empty() ? "" : ", ") + name + " (pid " + pid + ")";
    });
    return names;
}

} // namespace autostereo::devices::v4l2
