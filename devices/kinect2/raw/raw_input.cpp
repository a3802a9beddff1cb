#include "devices/kinect2/raw/raw_input.hpp"

#include "devices/kinect2/raw/raw_reader.hpp"
#include "devices/kinect2/unit_frames.hpp"

#include <chrono>
#include <fstream>
#include <utility>

namespace autostereo::devices::kinect2 {

namespace {

/// Media time of the start: what was half exposed then is not before zero.
constexpr Duration kLead = std::chrono::milliseconds(100);

std::unique_ptr<std::istream> opened(const std::filesystem::path& path) {
    return std::make_unique<std::ifstream>(path, std::ios::binary);
}

/// What makes frames of a stream's pictures.
struct Depth {
    using Raw = TimedDepth;
    using Frames = DepthFrames;
};
struct Color {
    using Raw = TimedColor;
    using Frames = ColorFrames;
};

/// One stream of a recording. It reads all packets, since the colour's times follow the depth's.
/// Thread-bound.
template<class Stream>
class RawSource final : public Source {
  public:
    RawSource(std::filesystem::path path, std::shared_ptr<const UnitFacts> facts)
        : path_(std::move(path)), facts_(std::move(facts)) {
        begin();
    }

    [[nodiscard]] ReadResult read(TimePoint) noexcept override try {
        while (reader_->next(record_)) {
            if (record_.header.kind == RawKind::Start && !startAnew()) break;
            if (!completes()) continue;
            typename Stream::Raw& raw = picture();
            raw.capturedAt -= zero_.time_since_epoch();
            if (auto frame = frames_->convert(raw)) return std::move(*frame);
        }
        return Ended{};
    } catch (const std::exception& error) {
        return Disconnected{path_.string() + ": " + error.what()};
    }
    [[nodiscard]] bool rewind() noexcept override try {
        begin();
        return true;
    } catch (const std::exception&) {
        return false;
    }
    [[nodiscard]] SourceCounters counters() const noexcept override {
        SourceCounters all = closed_;
        add(all);
        all.damaged += reader_->damaged() ? 1 : 0;
        return all;
    }

  private:
    static constexpr bool kIsDepth = std::is_same_v<Stream, Depth>;

    void begin() {
        if (frames_) add(closed_);
        reader_.emplace(opened(path_));
        continuity_ = std::make_shared<UnitContinuity>();
        frames_.reset();
        packets_ = {};
        zero_ = {};
    }
    /// As a camera that comes back. False: it is another one, or cut short.
    [[nodiscard]] bool startAnew() {
        const TimePoint time = record_.arrived();
        const auto pages = reader_->pages(record_);
        if (!pages || pages->serial != facts_->serial) return false;
        if (frames_) add(closed_);
        if constexpr (kIsDepth)
            frames_.emplace(continuity_, *facts_);
        else
            frames_.emplace(continuity_);
        packets_ = {};
        if (zero_ == TimePoint{}) zero_ = time - kLead;
        record_.header.kind = RawKind::Start; // no packet
        return true;
    }
    [[nodiscard]] bool completes() {
        if (!frames_) return false;
        const bool intact = record_.header.intact != 0;
        switch (record_.header.kind) {
        case RawKind::DepthPacket:
            return packets_.depth(record_.payload, intact, record_.arrived(), depth_) && kIsDepth;
        case RawKind::ColorPacket:
            return packets_.color(record_.payload, intact, record_.arrived(), color_) && !kIsDepth;
        default:
            return false;
        }
    }
    [[nodiscard]] typename Stream::Raw& picture() {
        if constexpr (kIsDepth)
            return depth_;
        else
            return color_;
    }
    /// What the present start has counted.
    void add(SourceCounters& all) const {
        if (!frames_) return;
        const auto packets = packets_.counters();
        all.delivered += frames_->counters().delivered;
        all.starved += frames_->counters().starved;
        all.damaged += frames_->counters().damaged +
                       (kIsDepth ? packets.depth.brokenFrames : packets.color.broken);
    }

    std::filesystem::path path_;
    std::shared_ptr<const UnitFacts> facts_;
    std::optional<RawReader> reader_;
    std::shared_ptr<UnitContinuity> continuity_;
    std::optional<typename Stream::Frames> frames_; ///< none: before the first start
    UnitPackets packets_;
    RawRecord record_;
    TimedDepth depth_;
    TimedColor color_;
    TimePoint zero_{}; ///< media time 0 on the recording host's clock
    SourceCounters closed_;
};

} // namespace

bool isRawRecording(const std::filesystem::path& path) {
    std::error_code error;
    return std::filesystem::is_regular_file(path, error) && RawReader(opened(path)).isRecording();
}

Input openRawRecording(const std::filesystem::path& path,
                       const std::optional<calib::SensorRig>& rig) {
    RawReader reader(opened(path));
    RawRecord start;
    std::optional<UnitPages> pages;
    if (reader.next(start) && start.header.kind == RawKind::Start) pages = reader.pages(start);
    if (!pages)
        throw DeviceError("cannot open " + path.string() +
                          ": a raw recording without a camera's pages" +
                          (reader.damaged() ? " (damaged)" : " (cut short)"));
    const auto facts = std::make_shared<const UnitFacts>(parseFacts(std::move(*pages)));
    Input input;
    input.uri = path.string();
    describe(input, *facts, rig);
    input.description = "raw recording of a " + input.description;
    input.startsAt = kLead;
    input.depth = std::make_unique<RawSource<Depth>>(path, facts);
    input.color = std::make_unique<RawSource<Color>>(path, facts);
    return input;
}

} // namespace autostereo::devices::kinect2
