#include "devices/replay/matroska_reader.hpp"

#include "devices/input.hpp"
#include "devices/replay/ebml_file.hpp"
#include "devices/replay/image.hpp"

#include <ebml/EbmlHead.h>
#include <matroska/KaxAttachments.h>
#include <matroska/KaxCluster.h>
#include <matroska/KaxContentEncoding.h>
#include <matroska/KaxSegment.h>
#include <matroska/KaxSemantic.h>
#include <matroska/KaxTags.h>
#include <matroska/KaxTracks.h>

#include <algorithm>
#include <array>
#include <utility>

namespace autostereo::devices {

namespace {

using namespace libmatroska;

constexpr std::size_t kMostTracks = 126; // numbers that fit into the one byte that we read

template<class Kind>
bool is(const EbmlHead& element) {
    return element.id == EBML_ID(Kind).GetValue();
}

int sideOf(const EbmlFile& file, const EbmlHead& element) {
    const std::uint64_t side = file.number(element);
    return side <= static_cast<std::uint64_t>(kLargestSide) ? static_cast<int>(side) : 0;
}

MatroskaTrack readTrack(EbmlFile& file, const EbmlHead& entry) {
    constexpr std::size_t kLargestPrivate = 64U << 10U;
    constexpr std::uint64_t kLongestPeriod = 60'000'000'000; // ns
    MatroskaTrack track;
    file.forEachChild(entry, [&](const EbmlHead& e) {
        if (is<KaxTrackNumber>(e))
            track.number =
                static_cast<unsigned>(std::min<std::uint64_t>(file.number(e), kMostTracks + 1));
        else if (is<KaxTrackName>(e))
            track.name = file.text(e);
        else if (is<KaxCodecID>(e))
            track.codec = file.text(e);
        else if (is<KaxCodecPrivate>(e))
            track.codecPrivate = file.bytes(e, kLargestPrivate);
        else if (is<KaxTrackDefaultDuration>(e))
            track.period = Duration{std::min(file.number(e), kLongestPeriod)};
        else if (is<KaxContentEncodings>(e))
            track.encoded = true;
        else if (is<KaxTrackVideo>(e))
            file.forEachChild(e, [&](const EbmlHead& v) {
                if (is<KaxVideoPixelWidth>(v)) track.width = sideOf(file, v);
                if (is<KaxVideoPixelHeight>(v)) track.height = sideOf(file, v);
            });
    });
    return track;
}

void readTag(EbmlFile& file, const EbmlHead& tag, MatroskaInfo& info) {
    constexpr std::size_t kMostTags = 4096;
    file.forEachChild(tag, [&](const EbmlHead& simple) {
        if (!is<KaxTagSimple>(simple) || info.tags.size() >= kMostTags) return;
        std::string name, value;
        file.forEachChild(simple, [&](const EbmlHead& e) {
            if (is<KaxTagName>(e)) name = file.text(e);
            if (is<KaxTagString>(e)) value = file.text(e);
        });
        info.tags.insert_or_assign(name, value);
    });
}

void readAttachment(EbmlFile& file, const EbmlHead& attached, MatroskaInfo& info) {
    constexpr std::size_t kMostAttachments = 16;
    constexpr std::size_t kLargestAttachment = 16U << 20U;
    if (info.attachments.size() >= kMostAttachments) return;
    std::string name;
    std::vector<std::byte> data;
    file.forEachChild(attached, [&](const EbmlHead& e) {
        if (is<KaxFileName>(e)) name = file.text(e);
        if (is<KaxFileData>(e)) data = file.bytes(e, kLargestAttachment);
    });
    info.attachments.insert_or_assign(name, std::move(data));
}

bool isSection(const EbmlHead& e) {
    return is<KaxInfo>(e) || is<KaxTracks>(e) || is<KaxTags>(e) || is<KaxAttachments>(e);
}

void readSection(EbmlFile& file, const EbmlHead& section, MatroskaInfo& info) {
    file.forEachChild(section, [&](const EbmlHead& e) {
        if (is<KaxTimecodeScale>(e))
            info.timecodeScale = std::clamp<std::uint64_t>(file.number(e), 1, 1'000'000'000);
        else if (is<KaxTrackEntry>(e) && info.tracks.size() < kMostTracks)
            info.tracks.push_back(readTrack(file, e));
        else if (is<KaxTag>(e))
            readTag(file, e, info);
        else if (is<KaxAttached>(e))
            readAttachment(file, e, info);
    });
}

} // namespace

MatroskaInfo readMatroskaInfo(const std::filesystem::path& path) {
    EbmlFile file(path);
    const auto header = file.headAt(0, file.size());
    const auto segment = header ? file.headAt(header->end, file.size()) : std::nullopt;
    if (!segment || !is<libebml::EbmlHead>(*header) || !is<KaxSegment>(*segment))
        throw DeviceError(path.string() + ": not a Matroska file, or its start is damaged");
    MatroskaInfo info;
    std::uint64_t at = segment->begin;
    // The segment's own size is not trusted: a recorder that was killed never wrote it.
    while (const auto e = file.headAt(at, file.size())) {
        if (is<KaxCluster>(*e) && info.firstCluster == 0) info.firstCluster = at;
        if (isSection(*e)) readSection(file, *e, info);
        at = e->end;
    }
    // Damaged before the first cluster: reading blocks goes on from there to the next one.
    if (info.firstCluster == 0) info.firstCluster = at;
    return info;
}

class MatroskaBlocks::Reader {
  public:
    Reader(const std::filesystem::path& path, const MatroskaInfo& info, unsigned track)
        : file_(path), scale_(info.timecodeScale), start_(info.firstCluster), track_(track),
          position_(start_) {}

    std::optional<MatroskaBlock> next() {
        while (position_ < file_.size()) {
            const auto e = file_.headAt(position_, file_.size());
            if (e && (is<KaxCluster>(*e) || is<KaxBlockGroup>(*e))) {
                position_ = e->begin; // their children come next
            } else if (!e || !e->whole) {
                ++damaged_;
                position_ = file_.find(EBML_ID(KaxCluster).GetValue(), position_ + 1);
            } else {
                position_ = e->end;
                if (is<KaxClusterTimecode>(*e)) clusterTicks_ = file_.number(*e);
                if (is<KaxSimpleBlock>(*e) || is<KaxBlock>(*e))
                    if (auto block = readBlock(*e)) return block;
            }
        }
        return std::nullopt;
    }

    void rewind() {
        position_ = start_;
        clusterTicks_ = 0;
    }
    [[nodiscard]] std::uint64_t damaged() const { return damaged_; }

  private:
    /// Four bytes of head (track, time, flags) and the payload; the library's own reader of blocks
    /// never ends on some damaged lacing.
    std::optional<MatroskaBlock> readBlock(const EbmlHead& e) {
        constexpr std::byte kLacing{0x06};
        constexpr std::size_t kLargestBlock = 512U << 20U;
        std::array<std::byte, 4> head{};
        const bool hasHead = e.size() >= head.size() && file_.readAt(e.begin, head);
        if (hasHead && head[0] != static_cast<std::byte>(0x80U | track_)) return std::nullopt;
        const auto time = timeOf(head[1], head[2]);
        if (hasHead && (head[3] & kLacing) == std::byte{0} && time && e.size() <= kLargestBlock) {
            payload_.resize(e.size() - head.size());
            if (file_.readAt(e.begin + head.size(), payload_))
                return MatroskaBlock{*time, payload_};
        }
        ++damaged_;
        return std::nullopt;
    }

    /// Cluster time plus the block's signed 16-bit offset; a year or more is damage.
    [[nodiscard]] std::optional<Duration> timeOf(std::byte high, std::byte low) const {
        constexpr std::uint64_t kLongest = 366ULL * 24 * 3600 * 1'000'000'000;
        if (clusterTicks_ > kLongest / scale_) return std::nullopt;
        const auto offset = static_cast<std::int16_t>(std::to_integer<unsigned>(high) << 8U |
                                                      std::to_integer<unsigned>(low));
        return Duration{(static_cast<std::int64_t>(clusterTicks_) + offset) *
                        static_cast<std::int64_t>(scale_)};
    }

    EbmlFile file_;
    std::uint64_t scale_;
    std::uint64_t start_;
    unsigned track_;
    std::uint64_t position_;
    std::uint64_t clusterTicks_ = 0;
    std::uint64_t damaged_ = 0;
    std::vector<std::byte> payload_;
};

MatroskaBlocks::MatroskaBlocks(const std::filesystem::path& path, const MatroskaInfo& info,
                               unsigned track)
    : reader_(std::make_unique<Reader>(path, info, track)) {}
MatroskaBlocks::~MatroskaBlocks() = default;

std::optional<MatroskaBlock> MatroskaBlocks::next() { return reader_->next(); }
void MatroskaBlocks::rewind() { reader_->rewind(); }
std::uint64_t MatroskaBlocks::damaged() const { return reader_->damaged(); }

} // namespace autostereo::devices
