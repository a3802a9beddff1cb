#include "devices/display/looking_glass_volumes.hpp"

#include "devices/display/bounded_file.hpp"

#include <algorithm>
#include <array>
#include <sstream>

namespace autostereo::devices {

namespace {

constexpr std::size_t kMostBytes = 1U << 20U;
constexpr const char* kCalibration = "LKG_calibration/visual.json";
constexpr const char* kBridge = ".local/share/LookingGlass/Bridge/Locations";

/// The kernel writes blanks, tabs, line feeds and backslashes as three octal digits.
std::string unescaped(const std::string& field) {
    const auto isOctal = [](char c) { return c >= '0' && c <= '7'; };
    std::string text;
    for (std::size_t i = 0; i < field.size(); ++i) {
        if (field[i] == '\\' && i + 3 < field.size() && field[i + 1] <= '3' &&
            std::all_of(&field[i + 1], &field[i + 4], isOctal)) {
            text += static_cast<char>((field[i + 1] - '0') * 64 + (field[i + 2] - '0') * 8 +
                                      (field[i + 3] - '0'));
            i += 3;
        } else {
            text += field[i];
        }
    }
    return text;
}

/// Names below /dev/disk/by-label hold blanks and the like as \x20.
std::string unescapedLabel(const std::string& name) {
    const auto digit = [](char c) {
        const std::size_t value = std::string_view("0123456789abcdef").find(c);
        return value == std::string_view::npos ? -1 : static_cast<int>(value);
    };
    std::string label;
    for (std::size_t i = 0; i < name.size(); ++i) {
        if (name[i] == '\\' && i + 3 < name.size() && name[i + 1] == 'x' &&
            digit(name[i + 2]) >= 0 && digit(name[i + 3]) >= 0) {
            label += static_cast<char>(digit(name[i + 2]) * 16 + digit(name[i + 3]));
            i += 3;
        } else {
            label += name[i];
        }
    }
    return label;
}

bool isBlockVolume(const Mount& mount) {
    constexpr std::array<std::string_view, 2> kOptical{"iso9660", "udf"};
    return mount.device.starts_with("/dev/") &&
           std::ranges::find(kOptical, mount.type) == kOptical.end();
}

std::filesystem::path below(const std::filesystem::path& root, const std::string& absolute) {
    return root / std::filesystem::path(absolute).relative_path();
}

std::vector<std::filesystem::path> entriesOf(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> found;
    std::error_code error;
    std::filesystem::directory_iterator entry(folder, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error))
        found.push_back(entry->path());
    std::ranges::sort(found);
    return found;
}

bool isFile(const std::filesystem::path& file) {
    std::error_code error;
    return std::filesystem::is_regular_file(file, error);
}

/// Volumes by label, without their calibration yet.
std::vector<LookingGlassVolume> labelled(const std::filesystem::path& root) {
    std::vector<LookingGlassVolume> found;
    for (const auto& link : entriesOf(root / "dev/disk/by-label")) {
        const std::string label = unescapedLabel(link.filename());
        std::error_code error;
        const auto target = std::filesystem::read_symlink(link, error);
        if (error || !label.starts_with("LKG-")) continue;
        const auto device = (std::filesystem::path("/dev/disk/by-label") / target);
        found.push_back({label, device.lexically_normal(), std::nullopt});
    }
    return found;
}

void addMounted(const std::filesystem::path& root, std::vector<LookingGlassVolume>& volumes) {
    const std::string text = readBoundedFile(root / "proc/mounts", kMostBytes).value_or("");
    for (const Mount& mount : parseMounts(text)) {
        if (!isBlockVolume(mount)) continue;
        const auto file = below(root, mount.point) / kCalibration;
        if (!isFile(file)) continue;
        const auto known = std::ranges::find(volumes, mount.device, &LookingGlassVolume::device);
        if (known == volumes.end())
            volumes.push_back({std::filesystem::path(mount.point).filename(), mount.device, file});
        else if (!known->calibration)
            known->calibration = file;
    }
}

} // namespace

std::vector<Mount> parseMounts(std::string_view text) {
    std::vector<Mount> mounts;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        std::istringstream fields(line);
        Mount mount;
        if (!(fields >> mount.device >> mount.point >> mount.type)) continue;
        mount.device = unescaped(mount.device);
        mount.point = unescaped(mount.point);
        mounts.push_back(std::move(mount));
    }
    return mounts;
}

std::vector<LookingGlassVolume> findLookingGlassVolumes(const std::filesystem::path& root,
                                                        const std::filesystem::path& home) {
    std::vector<LookingGlassVolume> found = labelled(root);
    addMounted(root, found);
    if (home.empty()) return found;
    for (const auto& serial : entriesOf(below(root, home) / kBridge))
        if (isFile(serial / kCalibration))
            found.push_back({serial.filename(), "", serial / kCalibration});
    return found;
}

std::optional<std::string> readCalibrationText(const std::filesystem::path& file) {
    return readBoundedFile(file, kMostBytes);
}

} // namespace autostereo::devices
