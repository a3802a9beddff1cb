#include "devices/display/calibration_cache.hpp"

#include "devices/display/bounded_file.hpp"
#include "devices/unique_fd.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace autostereo::devices {

namespace {

constexpr const char* kTemporary = ".new-"; // followed by six letters

bool isPlain(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
}

bool writeAll(int fd, std::string_view text) {
    while (!text.empty()) {
        const ssize_t count = ::write(fd, text.data(), text.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        text.remove_prefix(static_cast<std::size_t>(count));
    }
    return true;
}

} // namespace

std::optional<std::string> CalibrationCache::fileName(std::string_view serial) {
    constexpr std::size_t kLongest = 64;
    if (std::ranges::none_of(serial, isPlain)) return std::nullopt;
    std::string name(serial.substr(0, kLongest));
    std::ranges::replace_if(
        name, [](char c) { return !isPlain(c); }, '-');
    return name + ".json";
}

std::optional<std::string> CalibrationCache::load(std::string_view serial) const {
    const auto name = fileName(serial);
    if (!name) return std::nullopt;
    return readBoundedFile(folder_ / *name, kMostBytes);
}

std::optional<std::string> CalibrationCache::store(std::string_view serial,
                                                   std::string_view text) const {
    const auto name = fileName(serial);
    std::optional<std::string> wrong;
    std::error_code error;
    if (!name) {
        wrong = "its serial has no letters";
    } else if (text.size() > kMostBytes) {
        wrong = "it is longer than 1 MiB";
    } else if (std::filesystem::create_directories(folder_, error); error) {
        wrong = error.message();
    } else {
        removeLeftovers(*name);
        wrong = replace(folder_ / *name, text);
    }
    if (!wrong) return std::nullopt;
    return "cannot keep the calibration of " + name.value_or("a display") + " in " +
           folder_.string() + ": " + *wrong;
}

std::optional<std::string> CalibrationCache::replace(const std::filesystem::path& file,
                                                     std::string_view text) const {
    std::string temporary = file.string() + kTemporary + "XXXXXX";
    {
        const UniqueFd fd(::mkostemp(temporary.data(), O_CLOEXEC));
        if (!fd) return errnoText();
        if (!writeAll(fd.get(), text) || ::fchmod(fd.get(), 0644) != 0 || ::fsync(fd.get()) != 0) {
            const std::string why = errnoText();
            ::unlink(temporary.c_str());
            return why;
        }
    }
    if (::rename(temporary.c_str(), file.c_str()) != 0) {
        const std::string why = errnoText();
        ::unlink(temporary.c_str());
        return why;
    }
    // The new name, too, has to survive a power cut.
    const UniqueFd folder(::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder) ::fsync(folder.get());
    return std::nullopt;
}

/// A process that was killed while writing leaves its file; a young one may be another's at work.
void CalibrationCache::removeLeftovers(const std::string& name) const {
    constexpr auto kOld = std::chrono::minutes(10);
    std::error_code error;
    std::filesystem::directory_iterator entry(folder_, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        std::error_code ignored;
        if (entry->path().filename().string().starts_with(name + kTemporary) &&
            entry->last_write_time(ignored) + kOld < std::filesystem::file_time_type::clock::now())
            std::filesystem::remove(entry->path(), ignored);
    }
}

ChosenCalibration chooseCalibration(std::string_view serial,
                                    const std::optional<std::string>& fresh,
                                    const CalibrationValidator& problemWith,
                                    const CalibrationCache& cache) {
    using Origin = ChosenCalibration::Origin;
    const std::string display = "display " + std::string(serial) + ": ";
    ChosenCalibration chosen;
    std::string wrong = "it gives no calibration";
    if (fresh) {
        const auto problem = problemWith(*fresh);
        if (!problem) {
            chosen.origin = Origin::Fresh;
            chosen.text = *fresh;
            if (cache.load(serial) == fresh) return chosen; // spare the disk
            if (auto why = cache.store(serial, *fresh)) chosen.warnings.push_back(std::move(*why));
            return chosen;
        }
        wrong = "its calibration is not usable (" + *problem + ")";
    }
    const auto cached = cache.load(serial);
    const auto problem = cached ? problemWith(*cached) : std::nullopt;
    if (cached && !problem) {
        chosen.origin = Origin::Cached;
        chosen.text = *cached;
        chosen.warnings.push_back(display + wrong +
                                  ": the last good one is used; unplug its USB cable and plug it "
                                  "in again");
        return chosen;
    }
    if (problem) wrong += " and neither is the one that was kept (" + *problem + ")";
    chosen.warnings.push_back(
        display + wrong + ": unplug its USB cable and plug it in again, or give a display file");
    return chosen;
}

} // namespace autostereo::devices
