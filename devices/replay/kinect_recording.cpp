#include "devices/replay/kinect_recording.hpp"

#include "devices/replay/calibration_files.hpp"
#include "devices/replay/kinect_sources.hpp"

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>
#include <utility>

namespace autostereo::devices {

namespace {

constexpr const char* kFactoryFile = "calibration.json";

const MatroskaTrack* trackNamed(const MatroskaInfo& info, std::string_view name) {
    const auto found = std::find_if(info.tracks.begin(), info.tracks.end(),
                                    [&](const MatroskaTrack& t) { return t.name == name; });
    return found == info.tracks.end() ? nullptr : &*found;
}

/// The four letters in the BITMAPINFOHEADER of a V_MS/VFW/FOURCC track.
std::string fourCc(const MatroskaTrack& track) {
    constexpr std::size_t kOffset = 16;
    std::string code;
    if (track.codec != "V_MS/VFW/FOURCC" || track.codecPrivate.size() < kOffset + 4) return code;
    for (std::size_t i = kOffset; i < kOffset + 4; ++i)
        code += static_cast<char>(track.codecPrivate[i]);
    return code;
}

PictureSize sizeOf(const MatroskaTrack& track) { return {track.width, track.height}; }

std::string tagOr(const MatroskaInfo& info, const char* name, const std::string& fallback) {
    const auto found = info.tags.find(name);
    return found == info.tags.end() ? fallback : found->second;
}

double depthUnit(const MatroskaInfo& info) {
    constexpr double kMillimetre = 0.001;
    const std::string text = tagOr(info, kDepthUnitTag, "");
    double unit = 0;
    std::from_chars(text.data(), text.data() + text.size(), unit);
    return unit > 1e-6 && unit <= 1 ? unit : kMillimetre;
}

Duration startOffset(const MatroskaInfo& info) {
    constexpr std::int64_t kLongest = 366LL * 24 * 3600 * 1'000'000'000;
    const std::string text = tagOr(info, "K4A_START_OFFSET_NS", "0");
    std::int64_t offset = 0;
    std::from_chars(text.data(), text.data() + text.size(), offset);
    return Duration{std::clamp<std::int64_t>(offset, 0, kLongest)};
}

class Opener {
  public:
    Opener(const std::filesystem::path& path) : path_(path), info_(readMatroskaInfo(path)) {}

    Input open(const std::optional<calib::SensorRig>& rig) {
        const MatroskaTrack* depth = trackNamed(info_, "DEPTH");
        const MatroskaTrack* color = trackNamed(info_, "COLOR");
        if (depth == nullptr && color == nullptr)
            fail("no DEPTH and no COLOR track: no Azure Kinect recording, or its start is damaged");
        input_.description = "Azure Kinect recording";
        if (depth != nullptr) openDepth(*depth);
        if (color != nullptr) openColor(*color);
        input_.rig = rig ? *rig : calibration(depth, color);
        input_.factoryCalibration = attached(tagOr(info_, "K4A_CALIBRATION_FILE", kFactoryFile));
        if (depth != nullptr) checkSize(*depth, input_.rig->depth);
        if (color != nullptr) checkSize(*color, input_.rig->color);
        input_.startsAt = startsAt_ == Duration::max() ? Duration{0} : startsAt_;
        return std::move(input_);
    }

  private:
    [[noreturn]] void fail(const std::string& wrong) const {
        throw DeviceError(path_.string() + ": " + wrong);
    }

    void openDepth(const MatroskaTrack& depth) {
        if (fourCc(depth) != "b16g") fail("DEPTH track is '" + fourCc(depth) + "' (allowed b16g)");
        const MatroskaTrack* infrared = trackNamed(info_, "IR");
        const bool useInfrared =
            infrared != nullptr && fourCc(*infrared) == "b16g" && !infrared->encoded;
        input_.depth = std::make_unique<KinectDepthSource>(
            prepare(depth, "depth"), useInfrared ? std::optional(infrared->number) : std::nullopt);
    }

    void openColor(const MatroskaTrack& color) {
        constexpr std::pair<std::string_view, KinectColorFormat> kFormats[] = {
            {"MJPG", KinectColorFormat::Mjpg},
            {"NV12", KinectColorFormat::Nv12},
            {"YUY2", KinectColorFormat::Yuy2},
            {"BGRA", KinectColorFormat::Bgra}};
        const std::string code = fourCc(color);
        for (const auto& [name, format] : kFormats) {
            if (name != code) continue;
            input_.color =
                std::make_unique<KinectColorSource>(prepare(color, code + " colour"), format);
            return;
        }
        fail("COLOR track is '" + code + "' (allowed MJPG, NV12, YUY2, BGRA)");
    }

    /// What both streams need checked and noted before they open.
    KinectTrack prepare(const MatroskaTrack& track, const std::string& what) {
        if (track.encoded) fail(track.name + " track is compressed on top of its codec");
        if (track.width < 1 || track.height < 1 || track.width % 2 != 0 || track.height % 2 != 0)
            fail(track.name + " track has a size of " + sizeOf(track).text() +
                 " (allowed even, 2 to 16384)");
        KinectTrack result{path_,           info_, track.number, sizeOf(track), startOffset(info_),
                           depthUnit(info_)};
        input_.description += ", " + sizeOf(track).text() + " " + what;
        input_.nominalPeriod = std::max(input_.nominalPeriod, track.period);
        MatroskaBlocks blocks(path_, info_, track.number);
        if (const auto first = blocks.next())
            startsAt_ = std::min(startsAt_, first->time + result.startOffset);
        return result;
    }

    void checkSize(const MatroskaTrack& track, const calib::CameraModel& camera) const {
        const PictureSize size{camera.intrinsics.width, camera.intrinsics.height};
        if (size != sizeOf(track))
            fail(track.name + " track has pictures of " + sizeOf(track).text() +
                 ", the rig is for " + size.text());
    }

    [[nodiscard]] calib::SensorRig calibration(const MatroskaTrack* depth,
                                               const MatroskaTrack* color) const {
        const std::string own = tagOr(info_, kCameraFileTag, "");
        if (const auto file = attached(own); !file.empty())
            return readCameraFile(file, path_.string() + ": " + own).rig();
        const std::string name = tagOr(info_, "K4A_CALIBRATION_FILE", kFactoryFile);
        const auto factory = attached(name);
        if (factory.empty()) fail("no " + name + " attached (use --rig)");
        const auto size = [](const MatroskaTrack* track) {
            return track == nullptr ? PictureSize{} : sizeOf(*track);
        };
        return readKinectCalibration(factory, path_.string() + ": " + name, size(depth),
                                     size(color));
    }

    [[nodiscard]] std::vector<std::byte> attached(const std::string& name) const {
        const auto found = info_.attachments.find(name);
        return found == info_.attachments.end() ? std::vector<std::byte>{} : found->second;
    }

    std::filesystem::path path_;
    MatroskaInfo info_;
    Input input_;
    Duration startsAt_ = Duration::max();
};

} // namespace

Input openKinectRecording(const std::filesystem::path& path,
                          const std::optional<calib::SensorRig>& rig) {
    return Opener(path).open(rig);
}

} // namespace autostereo::devices
