#include "devices/replay/picture_input.hpp"

#include <array>
#include <utility>

namespace autostereo::devices {

Input openRgbd(const Uri& uri, const std::optional<calib::SensorRig>& rig) {
    uri.allowOnly({});
    std::array<std::string, 3> parts; // colour, depth, camera
    std::size_t part = 0;
    for (const char c : uri.path) {
        if (c != ',')
            parts[part] += c;
        else if (++part == parts.size())
            throw DeviceError(uri.text + ": too many parts (rgbd:color.png,depth.png,camera.json)");
    }
    PictureLists lists;
    const auto add = [&](const std::string& path, std::vector<Picture>& list) {
        if (path.empty()) return;
        if (!std::filesystem::is_regular_file(path))
            throw DeviceError(uri.text + ": " + path + " is not there", true);
        list.push_back({path, {}});
    };
    add(parts[0], lists.color);
    add(parts[1], lists.depth);
    std::optional<CameraFile> cameras;
    if (!parts[2].empty()) cameras = readCameraFile(parts[2]);
    if (cameras && cameras->depthUnitM) lists.depthUnitM = *cameras->depthUnitM;
    return inputFromPictures(uri, "picture pair", std::move(lists), rig, cameras);
}

} // namespace autostereo::devices
