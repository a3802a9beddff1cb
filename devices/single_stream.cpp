#include "devices/single_stream.hpp"

#include "devices/grey_picture.hpp"
#include "devices/twin_stream.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace autostereo::devices {

namespace {

constexpr int kFlatColumns = 64;
constexpr std::uint16_t kFlatCounts = 1000; // 1 m in millimetres

class TwinSource final : public Source {
  public:
    TwinSource(std::shared_ptr<TwinStream> stream, TwinStream::Side side)
        : stream_(std::move(stream)), side_(side) {}

    [[nodiscard]] ReadResult read(TimePoint deadline) noexcept override {
        return stream_->read(side_, deadline);
    }
    [[nodiscard]] bool rewind() noexcept override { return stream_->rewind(side_); }
    [[nodiscard]] SourceCounters counters() const noexcept override {
        return stream_->counters(side_);
    }

  private:
    std::shared_ptr<TwinStream> stream_; // both sides own it: their threads end in any order
    TwinStream::Side side_;
};

const calib::CameraModel&
knownCamera(const Input& input, calib::CameraModel calib::SensorRig::*which, const char* name) {
    const auto problem = input.rig ? problemWith((*input.rig).*which) : "there is none";
    if (problem)
        throw DeviceError(input.uri + ": cannot complete the input: calibration of its " + name +
                          " camera: " + *problem + " (give one with --rig)");
    return (*input.rig).*which;
}

/// A coarse grid over the whole colour picture. Its outermost pixel centres lie on the picture's
/// edges, because a mesh reaches from centre to centre.
calib::CameraModel flatCamera(const calib::CameraModel& color) {
    const double aspect = static_cast<double>(color.intrinsics.height) / color.intrinsics.width;
    const int rows = std::max(2, static_cast<int>(std::lround(kFlatColumns * aspect)));
    calib::CameraModel grid = color.resized(kFlatColumns, rows);
    calib::Intrinsics& k = grid.intrinsics;
    const double across = (k.width - 1.0) / k.width;
    const double down = (k.height - 1.0) / k.height;
    k.fx *= across;
    k.cx = (k.cx + 0.5) * across;
    k.fy *= down;
    k.cy = (k.cy + 0.5) * down;
    return grid;
}

TwinStream::Painter flatDepth(const calib::Intrinsics& grid) {
    const auto describe = [width = grid.width, height = grid.height](const FrameMetadata& color) {
        FrameMetadata flat = color;
        flat.format = PixelFormat::Depth16;
        flat.width = width;
        flat.height = height;
        flat.depthUnitM = 0.001;
        flat.hasAmplitude = false;
        return flat;
    };
    return {describe,
            [](const Frame&, Frame& flat) { std::ranges::fill(flat.depth(), kFlatCounts); }};
}

TwinStream::Painter shadedGrey(const calib::CameraModel& camera) {
    const auto describe = [](const FrameMetadata& depth) {
        FrameMetadata grey = depth;
        grey.format = PixelFormat::Rgba8;
        grey.hasAmplitude = false;
        return grey;
    };
    return {describe, [picture = GreyPicture(camera)](const Frame& depth, Frame& color) mutable {
                picture.paint(depth, color);
            }};
}

/// One stream of an input, in its three places.
struct Slot {
    std::unique_ptr<Source>& source;
    Reopen& reopen;
    bool& live;
};

void split(const Slot& real, const Slot& missing, TwinStream::Painter painter) {
    const auto stream = std::make_shared<TwinStream>(std::move(real.source), std::move(painter),
                                                     real.reopen != nullptr);
    real.source = std::make_unique<TwinSource>(stream, TwinStream::Real);
    missing.source = std::make_unique<TwinSource>(stream, TwinStream::Companion);
    missing.live = real.live;
    if (!real.reopen) return;
    real.reopen = [stream, again = std::move(real.reopen)] {
        stream->replace(again());
        return std::make_unique<TwinSource>(stream, TwinStream::Real);
    };
}

} // namespace

Input completeStreams(Input input) {
    if (input.depth && input.color) return input;
    if (!input.depth && !input.color)
        throw DeviceError(input.uri + ": cannot open the input: it has no stream to show");
    const Slot depth{input.depth, input.reopen.depth, input.depthIsLive};
    const Slot color{input.color, input.reopen.color, input.colorIsLive};
    if (input.color) {
        const calib::CameraModel camera = knownCamera(input, &calib::SensorRig::color, "colour");
        input.rig->depth = flatCamera(camera);
        split(color, depth, flatDepth(input.rig->depth.intrinsics));
    } else {
        const calib::CameraModel camera = knownCamera(input, &calib::SensorRig::depth, "depth");
        input.rig->color = camera;
        split(depth, color, shadedGrey(camera));
    }
    input.rig->colorFromDepth = calib::RigidTransform{};
    return input;
}

} // namespace autostereo::devices
