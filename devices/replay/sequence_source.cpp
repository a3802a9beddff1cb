#include "devices/replay/picture_input.hpp"

#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

namespace autostereo::devices {

namespace {

using Numbered = std::map<long, std::filesystem::path>;

struct Folder {
    Numbered depth;
    Numbered color;
    Numbered plainPng; ///< N.png: depth or colour, as its pixels say
};

/// The number that `digits` is, or -1; at most nine digits, so that media time stays in range.
long numberOf(const std::string& digits) {
    if (digits.empty() || digits.size() > 9) return -1;
    for (const char c : digits)
        if (std::isdigit(static_cast<unsigned char>(c)) == 0) return -1;
    return std::stol(digits);
}

/// What a file's name says about it.
struct Naming {
    std::string_view prefix;
    std::string_view ending;
    Numbered Folder::*list;
};

constexpr std::array kNamings{
    Naming{"frame-", ".depth.png", &Folder::depth},
    Naming{"frame-", ".color.jpg", &Folder::color},
    Naming{"frame-", ".color.png", &Folder::color},
    Naming{"", ".jpg", &Folder::color},
    Naming{"", ".jpeg", &Folder::color},
    Naming{"", ".png", &Folder::plainPng},
};

void sortIn(Folder& folder, const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    for (const Naming& naming : kNamings) {
        if (!name.starts_with(naming.prefix) || !name.ends_with(naming.ending)) continue;
        const std::size_t around = naming.prefix.size() + naming.ending.size();
        if (name.size() <= around) continue;
        const long number = numberOf(name.substr(naming.prefix.size(), name.size() - around));
        if (number >= 0) (folder.*naming.list).emplace(number, path);
    }
}

/// What N.png files are is decided for the whole folder by the first that opens.
bool holdsDepth(const Numbered& pngs) {
    ImageReader reader;
    int tries = 16;
    for (auto file = pngs.begin(); file != pngs.end() && tries > 0; ++file, --tries) {
        try {
            return reader.open(file->second).format == ImageFormat::Grey16;
        } catch (const std::exception&) {
            continue; // counted as damaged when it is its turn
        }
    }
    return true;
}

std::vector<Picture> pictures(const Numbered& files, long first, double fps) {
    std::vector<Picture> result;
    for (const auto& [number, path] : files) {
        const double seconds = static_cast<double>(number - first) / fps;
        result.push_back({path, TimePoint{Duration{std::llround(seconds * 1e9)}}});
    }
    return result;
}

} // namespace

Input openSequence(const Uri& uri, const std::optional<calib::SensorRig>& rig) {
    uri.allowOnly({"fps"});
    const double fps = uri.number("fps", 30, 1, 1000);
    const std::filesystem::path directory = uri.path;
    if (!std::filesystem::is_directory(directory))
        throw DeviceError(uri.text + ": " + uri.path + " is no folder", true);
    Folder folder;
    for (const auto& entry : std::filesystem::directory_iterator(directory))
        if (entry.is_regular_file()) sortIn(folder, entry.path());
    (holdsDepth(folder.plainPng) ? folder.depth : folder.color).merge(folder.plainPng);

    long first = std::numeric_limits<long>::max();
    for (const Numbered* list : {&folder.depth, &folder.color})
        if (!list->empty()) first = std::min(first, list->begin()->first);
    PictureLists lists;
    lists.depth = pictures(folder.depth, first, fps);
    lists.color = pictures(folder.color, first, fps);
    lists.nominalPeriod = Duration{std::llround(1e9 / fps)};
    std::optional<CameraFile> cameras;
    if (std::filesystem::exists(directory / "camera.json"))
        cameras = readCameraFile(directory / "camera.json");
    if (cameras && cameras->depthUnitM) lists.depthUnitM = *cameras->depthUnitM;
    return inputFromPictures(uri, "picture folder (frame-N.color.jpg, N.jpg)", std::move(lists),
                             rig, cameras);
}

} // namespace autostereo::devices
