#include "devices/replay/picture_input.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>
#include <utility>

namespace autostereo::devices {

namespace {

struct Entry {
    double seconds = 0;
    std::filesystem::path path;
};

struct List {
    std::vector<Entry> entries; ///< those whose file is there
    std::string comments;
};

/// Unix time in seconds and a file per line; '#' starts a comment. Bad lines are left out.
List readList(const std::filesystem::path& folder, const char* name) {
    constexpr double kLatest = 4e9; // year 2096; keeps nanoseconds well inside 64 bits
    List list;
    std::ifstream file(folder / name);
    for (std::string line; std::getline(file, line);) {
        if (!line.empty() && line.front() == '#') {
            list.comments += line;
            continue;
        }
        std::istringstream fields(line);
        Entry entry;
        std::string relative;
        if (!(fields >> entry.seconds >> relative)) continue;
        if (!(entry.seconds >= 0 && entry.seconds <= kLatest)) continue;
        entry.path = folder / relative;
        std::error_code error;
        if (std::filesystem::is_regular_file(entry.path, error))
            list.entries.push_back(std::move(entry));
    }
    std::stable_sort(list.entries.begin(), list.entries.end(),
                     [](const Entry& a, const Entry& b) { return a.seconds < b.seconds; });
    return list;
}

std::vector<Picture> pictures(const List& list, double zero) {
    std::vector<Picture> result;
    for (const Entry& entry : list.entries) {
        const Duration since{std::llround((entry.seconds - zero) * 1e9)};
        result.push_back({entry.path, TimePoint{since}});
    }
    return result;
}

/// Mean distance of frames, 0 where there are too few.
Duration meanPeriod(const std::vector<Picture>& list) {
    if (list.size() < 2) return Duration{0};
    return (list.back().capturedAt - list.front().capturedAt) / (list.size() - 1);
}

/// The colour cameras that the benchmark publishes, by number of the set.
std::optional<CameraFile> publishedCamera(const std::string& hints) {
    constexpr std::array<std::array<double, 9>, 3> kSets{{
        {517.3, 516.5, 318.6, 255.3, 0.2624, -0.9531, -0.0054, 0.0026, 1.1633},
        {520.9, 521.0, 325.1, 249.7, 0.2312, -0.7849, -0.0033, -0.0001, 0.9172},
        {535.4, 539.2, 320.1, 247.6, 0, 0, 0, 0, 0}, // published already undistorted
    }};
    for (std::size_t set = 0; set < kSets.size(); ++set) {
        const std::string number = std::to_string(set + 1);
        if (hints.find("freiburg" + number) == std::string::npos &&
            hints.find("fr" + number) == std::string::npos)
            continue;
        const auto& k = kSets[set];
        CameraFile camera;
        camera.color.emplace();
        camera.color->intrinsics = {640, 480, k[0], k[1], k[2], k[3]};
        camera.color->distortion = {k[4], k[5], k[6], k[7], k[8], 0, 0, 0};
        camera.name = "published for freiburg" + number;
        return camera;
    }
    return std::nullopt;
}

} // namespace

Input openTum(const Uri& uri, const std::optional<calib::SensorRig>& rig) {
    uri.allowOnly({"camera"});
    const std::filesystem::path folder = uri.path;
    if (!std::filesystem::is_directory(folder))
        throw DeviceError(uri.text + ": " + uri.path + " is no folder", true);
    const List depth = readList(folder, "depth.txt"), color = readList(folder, "rgb.txt");
    double zero = std::numeric_limits<double>::max();
    for (const List* list : {&depth, &color})
        if (!list->entries.empty()) zero = std::min(zero, list->entries.front().seconds);

    std::optional<CameraFile> camera;
    if (const std::string file = uri.value("camera"); !file.empty())
        camera = readCameraFile(file);
    else
        camera = publishedCamera((std::filesystem::absolute(folder).lexically_normal() / "")
                                     .parent_path()
                                     .filename()
                                     .string() +
                                 color.comments + depth.comments);
    PictureLists lists;
    lists.depth = pictures(depth, zero);
    lists.color = pictures(color, zero);
    lists.depthUnitM = camera && camera->depthUnitM ? *camera->depthUnitM : 1.0 / 5000;
    lists.nominalPeriod = meanPeriod(lists.depth.empty() ? lists.color : lists.depth);
    return inputFromPictures(uri, "TUM RGB-D recording (rgb.txt, depth.txt)", std::move(lists), rig,
                             camera);
}

} // namespace autostereo::devices
