#include "devices/record/matroska_writer.hpp"

#include "devices/record/ebml_bytes.hpp"

#include <ebml/EbmlHead.h>
#include <ebml/EbmlSubHead.h>
#include <matroska/KaxAttachments.h>
#include <matroska/KaxCluster.h>
#include <matroska/KaxCues.h>
#include <matroska/KaxCuesData.h>
#include <matroska/KaxSegment.h>
#include <matroska/KaxSemantic.h>
#include <matroska/KaxTags.h>
#include <matroska/KaxTracks.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/uio.h>
#include <unistd.h>

namespace autostereo::devices {

namespace {

using namespace libmatroska;
using namespace libebml;

constexpr std::uint64_t kNanosecondsPerTick = 1000; // as the vendor's recorder has it
constexpr std::uint64_t kTicksPerCue = 1'000'000;

// Names from the library's tables, so that no number here stands for an element.
template<class Element>
std::uint32_t id() {
    return static_cast<std::uint32_t>(EBML_ID(Element).GetValue());
}

/// What players tell pictures by: BITMAPINFOHEADER, little-endian.
std::vector<std::byte> bitmapHeader(const RecordingTrack& track) {
    std::vector<std::byte> header;
    const auto add = [&](std::uint32_t value, int length) {
        for (int i = 0; i < length; ++i)
            header.push_back(static_cast<std::byte>(value >> (8 * i)));
    };
    const bool compressed = track.fourCc == "MJPG";
    const auto width = static_cast<std::uint32_t>(track.width);
    const auto height = static_cast<std::uint32_t>(track.height);
    const auto bits = static_cast<std::uint32_t>(track.bitsPerPixel);
    add(40, 4);
    add(width, 4);
    add(height, 4);
    add(1, 2); // planes
    add(bits, 2);
    for (const char letter : track.fourCc)
        header.push_back(static_cast<std::byte>(letter));
    add(compressed ? 0 : width * height * bits / 8, 4);
    for (int rest = 0; rest < 4; ++rest)
        add(0, 4);
    return header;
}

EbmlBytes trackEntry(const RecordingTrack& track, unsigned number) {
    constexpr std::uint64_t kVideo = 1;
    EbmlBytes picture;
    picture.number(id<KaxVideoPixelWidth>(), static_cast<std::uint64_t>(track.width))
        .number(id<KaxVideoPixelHeight>(), static_cast<std::uint64_t>(track.height));
    EbmlBytes entry;
    entry.number(id<KaxTrackNumber>(), number)
        .number(id<KaxTrackUID>(), number)
        .number(id<KaxTrackType>(), kVideo)
        .number(id<KaxTrackFlagLacing>(), 0)
        .text(id<KaxCodecID>(), "V_MS/VFW/FOURCC")
        .text(id<KaxTrackName>(), track.name)
        .data(id<KaxCodecPrivate>(), bitmapHeader(track));
    if (track.period > Duration{0})
        entry.number(id<KaxTrackDefaultDuration>(),
                     static_cast<std::uint64_t>(track.period.count()));
    return entry.group(id<KaxTrackVideo>(), picture);
}

/// `target`: empty for the whole file.
EbmlBytes tag(const EbmlBytes& target, const std::string& name, const std::string& value) {
    EbmlBytes simple, tag;
    simple.text(id<KaxTagName>(), name).text(id<KaxTagString>(), value);
    return tag.group(id<KaxTagTargets>(), target).group(id<KaxTagSimple>(), simple);
}

EbmlBytes tagsOf(const RecordingLayout& layout) {
    EbmlBytes tags;
    for (std::size_t i = 0; i < layout.tracks.size(); ++i) {
        EbmlBytes target;
        target.text(id<KaxTagTargetType>(), "TRACK").number(id<KaxTagTrackUID>(), i + 1);
        for (const auto& [name, value] : layout.tracks[i].tags)
            tags.group(id<KaxTag>(), tag(target, name, value));
    }
    for (std::size_t i = 0; i < layout.attachments.size(); ++i) {
        EbmlBytes target;
        target.text(id<KaxTagTargetType>(), "ATTACHMENT").number(id<KaxTagAttachmentUID>(), i + 1);
        const RecordingAttachment& file = layout.attachments[i];
        tags.group(id<KaxTag>(), tag(target, file.tag, file.name));
    }
    for (const auto& [name, value] : layout.tags)
        tags.group(id<KaxTag>(), tag({}, name, value));
    return tags;
}

EbmlBytes attachmentsOf(const RecordingLayout& layout) {
    EbmlBytes attachments;
    for (std::size_t i = 0; i < layout.attachments.size(); ++i) {
        EbmlBytes file;
        file.text(id<KaxFileName>(), layout.attachments[i].name)
            .text(id<KaxMimeType>(), "application/octet-stream")
            .data(id<KaxFileData>(), layout.attachments[i].data)
            .number(id<KaxFileUID>(), i + 1);
        attachments.group(id<KaxAttached>(), file);
    }
    return attachments;
}

} // namespace

MatroskaWriter::MatroskaWriter(const std::filesystem::path& path, const RecordingLayout& layout)
    : path_(path), fd_(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)) {
    if (!fd_) fail(errno);
    writeHead(layout);
}

MatroskaWriter::~MatroskaWriter() = default;

void MatroskaWriter::writeHead(const RecordingLayout& layout) {
    EbmlBytes kind, start;
    kind.number(id<EVersion>(), 1)
        .number(id<EReadVersion>(), 1)
        .number(id<EMaxIdLength>(), 4)
        .number(id<EMaxSizeLength>(), 8)
        .text(id<EDocType>(), "matroska")
        .number(id<EDocTypeVersion>(), 2)
        .number(id<EDocTypeReadVersion>(), 2);
    start.group(id<EbmlHead>(), kind).head(id<KaxSegment>(), EbmlBytes::kUnknownSize);
    segmentBegin_ = start.size();

    EbmlBytes info;
    info.real(id<KaxDuration>(), 0); // first: it is overwritten at the end
    const std::size_t durationEnd = info.size();
    info.number(id<KaxTimecodeScale>(), kNanosecondsPerTick)
        .text(id<KaxMuxingApp>(), "autostereo")
        .text(id<KaxWritingApp>(), "autostereo")
        .text(id<KaxTitle>(), "Azure Kinect");
    start.group(id<KaxInfo>(), info);
    durationAt_ = start.size() - info.size() + durationEnd - sizeof(double);

    EbmlBytes tracks;
    for (std::size_t i = 0; i < layout.tracks.size(); ++i)
        tracks.group(id<KaxTrackEntry>(),
                     trackEntry(layout.tracks[i], static_cast<unsigned>(i + 1)));
    start.group(id<KaxTracks>(), tracks);
    if (!layout.attachments.empty()) start.group(id<KaxAttachments>(), attachmentsOf(layout));
    append(start.group(id<KaxTags>(), tagsOf(layout)).bytes());
}

void MatroskaWriter::write(unsigned track, Duration time, std::span<const std::byte> payload) {
    const auto ticks =
        static_cast<std::uint64_t>(std::max<std::int64_t>(0, time.count())) / kNanosecondsPerTick;
    const std::array<std::byte, 4> blockHead{static_cast<std::byte>(0x80U | track), std::byte{0},
                                             std::byte{0}, std::byte{0x80}}; // no offset; key frame
    EbmlBytes inside;
    inside.number(id<KaxClusterTimecode>(), ticks)
        .head(id<KaxSimpleBlock>(), blockHead.size() + payload.size());
    EbmlBytes start;
    start.head(id<KaxCluster>(), inside.size() + blockHead.size() + payload.size());
    std::vector<std::byte> head;
    for (const auto part : {start.bytes(), inside.bytes(), std::span<const std::byte>(blockHead)})
        head.insert(head.end(), part.begin(), part.end());
    if (cues_.empty() || ticks >= cues_.back().ticks + kTicksPerCue)
        cues_.push_back({ticks, track, position_ - segmentBegin_});
    append(head, payload);
    lastTicks_ = std::max(lastTicks_, ticks);
}

void MatroskaWriter::finish() {
    EbmlBytes cues;
    for (const Cue& cue : cues_) {
        EbmlBytes place, point;
        place.number(id<KaxCueTrack>(), cue.track)
            .number(id<KaxCueClusterPosition>(), cue.position);
        point.number(id<KaxCueTime>(), cue.ticks).group(id<KaxCueTrackPositions>(), place);
        cues.group(id<KaxCuePoint>(), point);
    }
    if (!cues_.empty()) {
        EbmlBytes index;
        append(index.group(id<KaxCues>(), cues).bytes());
    }
    EbmlBytes duration, segment;
    duration.real(id<KaxDuration>(), static_cast<double>(lastTicks_));
    patch(durationAt_, duration.bytes().last(sizeof(double)));
    segment.head(id<KaxSegment>(), position_ - segmentBegin_);
    patch(segmentBegin_ - sizeof(std::uint64_t), segment.bytes().last(sizeof(std::uint64_t)));
}

void MatroskaWriter::append(std::span<const std::byte> first, std::span<const std::byte> second) {
    while (!first.empty() || !second.empty()) {
        // writev takes pointers to mutable bytes, and leaves them alone.
        const std::array<iovec, 2> parts{{{const_cast<std::byte*>(first.data()), first.size()},
                                          {const_cast<std::byte*>(second.data()), second.size()}}};
        const ssize_t written = ::writev(fd_.get(), parts.data(), static_cast<int>(parts.size()));
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) fail(written < 0 ? errno : ENOSPC);
        const auto done = static_cast<std::size_t>(written);
        position_ += done;
        const std::size_t ofFirst = std::min(done, first.size());
        first = first.subspan(ofFirst);
        second = second.subspan(done - ofFirst);
    }
}

void MatroskaWriter::patch(std::uint64_t at, std::span<const std::byte> bytes) {
    if (::pwrite(fd_.get(), bytes.data(), bytes.size(), static_cast<off_t>(at)) !=
        static_cast<ssize_t>(bytes.size()))
        fail(errno);
}

void MatroskaWriter::fail(int cause) const {
    throw RecordingError("cannot record to " + path_.string() + ": " + std::strerror(cause));
}

} // namespace autostereo::devices
