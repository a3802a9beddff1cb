#include "devices/replay/picture_input.hpp"

#include "devices/nominal_camera.hpp"
#include <algorithm>
#include <array>
#include <exception>
#include <utility>

namespace autostereo::devices {

namespace {

/// Size of the first picture that opens; 0x0 where none of the first few does.
PictureSize sizeOf(const std::vector<Picture>& pictures) {
    constexpr std::size_t kMostTried = 16;
    ImageReader reader;
    for (std::size_t i = 0; i < std::min(kMostTried, pictures.size()); ++i) {
        try {
            return reader.open(pictures[i].path).size();
        } catch (const std::exception&) {
            continue; // counted as damaged when it is its turn
        }
    }
    return {};
}

std::optional<calib::SensorRig> nominalRig(PictureSize depth, PictureSize color) {
    if (depth == PictureSize{}) depth = color;
    if (color == PictureSize{}) color = depth;
    if (depth == PictureSize{}) return std::nullopt; // nothing readable: no size to go by
    return calib::SensorRig{nominalCamera(depth.width, depth.height),
                            nominalCamera(color.width, color.height),
                            {},
                            "nominal"};
}

/// A file with one camera is read as "registered": the other picture may have another size.
calib::SensorRig rigFrom(const CameraFile& cameras, PictureSize depth, PictureSize color) {
    calib::SensorRig rig = cameras.rig();
    if (!cameras.depth && depth != PictureSize{})
        rig.depth = rig.depth.resized(depth.width, depth.height);
    if (!cameras.color && color != PictureSize{})
        rig.color = rig.color.resized(color.width, color.height);
    return rig;
}

PictureSize sizeOf(const calib::CameraModel& camera) {
    return {camera.intrinsics.width, camera.intrinsics.height};
}

/// The size a stream's pictures must have, with a warning where the first one already differs.
PictureSize expectedSize(Input& input, const calib::CameraModel* camera, PictureSize seen,
                         const std::string& stream) {
    if (camera == nullptr) return seen;
    const PictureSize expected = sizeOf(*camera);
    if (seen != PictureSize{} && seen != expected)
        input.warnings.push_back(stream + " pictures are " + seen.text() +
                                 ", the calibration is for " + expected.text() +
                                 ": pictures of another size are dropped");
    return expected;
}

} // namespace

Input inputFromPictures(const Uri& uri, const std::string& kind, PictureLists lists,
                        const std::optional<calib::SensorRig>& rig,
                        const std::optional<CameraFile>& cameras) {
    if (lists.depth.empty() && lists.color.empty())
        throw DeviceError(uri.text + ": no pictures found (" + kind + ")", true);
    const PictureSize depth = sizeOf(lists.depth), color = sizeOf(lists.color);
    Input input;
    input.uri = uri.text;
    input.nominalPeriod = lists.nominalPeriod;
    if (rig) {
        input.rig = rig;
    } else if (cameras) {
        input.rig = rigFrom(*cameras, depth, color);
    } else {
        input.rig = nominalRig(depth, color);
        input.warnings.push_back(uri.text + ": no calibration: assuming registered pictures and a "
                                            "63 degree field of view (give camera.json or --rig)");
    }
    input.description = kind;
    auto startsAt = TimePoint::max();
    const auto open = [&](std::vector<Picture>& pictures, PixelFormat format, PictureSize seen,
                          const calib::CameraModel* camera,
                          const std::string& name) -> std::unique_ptr<Source> {
        if (pictures.empty()) return nullptr;
        startsAt = std::min(startsAt, pictures.front().capturedAt);
        input.description +=
            ", " + std::to_string(pictures.size()) + " " + name + " pictures " + seen.text();
        return std::make_unique<PictureSource>(
            std::move(pictures), format, expectedSize(input, camera, seen, name), lists.depthUnitM);
    };
    input.depth = open(lists.depth, PixelFormat::Depth16, depth,
                       input.rig ? &input.rig->depth : nullptr, "depth");
    input.color = open(lists.color, PixelFormat::Rgba8, color,
                       input.rig ? &input.rig->color : nullptr, "colour");
    input.startsAt = startsAt.time_since_epoch();
    return input;
}

} // namespace autostereo::devices
