#include "devices/kinect2/raw/raw_recorder.hpp"

#include "devices/kinect2/little_endian.hpp"
#include "devices/record/matroska_writer.hpp"

#include <spdlog/spdlog.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

namespace autostereo::devices::kinect2 {

namespace {

constexpr std::size_t kChunkBytes = std::size_t{4} << 20U;
static_assert(kMostRawPayload + sizeof(RawHeader) <= kChunkBytes);
/// So much memory stays for the next chunks: two frames' worth.
constexpr std::size_t kMostUsed = 4;
constexpr auto kLongest = std::chrono::milliseconds(100);

/// All of it; else errno.
int writeAll(int file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(file, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) return errno;
        if (count == 0) return ENOSPC;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return 0;
}

std::string refusal(const std::filesystem::path& path, int cause) {
    return "cannot record to " + path.string() + ": " + std::strerror(cause);
}

} // namespace

RawRecorder::RawRecorder(std::filesystem::path file, std::size_t mostBytes)
    : path_(std::move(file)), mostBytes_(mostBytes),
      file_(open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644)) {
    const int cause = file_ ? writeAll(file_.get(), std::as_bytes(std::span(kRawMagic))) : errno;
    if (cause != 0) throw RecordingError(refusal(path_, cause));
    counters_.bytes = kRawMagic.size();
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

RawRecorder::~RawRecorder() { finish(); }

void RawRecorder::finish() {
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
}

RawRecording::Counters RawRecorder::counters() const {
    const std::lock_guard lock(mutex_);
    return counters_;
}

void RawRecorder::start(const UnitPages& pages, TimePoint time) {
    const std::lock_guard lock(mutex_);
    pages_ = pages;
    startedAt_ = time;
    lastDepthEmpty_ = false;
    full_ = !addStart();
}

bool RawRecorder::addStart() {
    if (!pages_) return true;
    const UnitPages& all = *pages_;
    const auto text = [](const std::string& words) { return std::as_bytes(std::span(words)); };
    const std::array<std::pair<RawKind, std::span<const std::byte>>, 5> records{
        {{RawKind::Start, text(all.serial)},
         {RawKind::Firmware, text(all.firmware)},
         {RawKind::PhasePage, all.phases},
         {RawKind::DepthPage, all.depth},
         {RawKind::ColorPage, all.color}}};
    std::size_t bytes = 0;
    for (const auto& [kind, payload] : records)
        bytes += sizeof(RawHeader) + payload.size();
    if (!hasRoom(bytes)) return false; // all or nothing
    for (const auto& [kind, payload] : records)
        static_cast<void>(add(kind, payload, true, startedAt_));
    pages_.reset();
    return true;
}

void RawRecorder::depth(std::span<const std::byte> packet, bool intact, TimePoint arrived) {
    const std::lock_guard lock(mutex_);
    const bool says = !packet.empty() || !intact;
    if (!says && lastDepthEmpty_) return;
    lastDepthEmpty_ = !says;
    addPacket(RawKind::DepthPacket, packet, intact, arrived);
}

void RawRecorder::color(std::span<const std::byte> packet, bool intact, TimePoint arrived) {
    const std::lock_guard lock(mutex_);
    addPacket(RawKind::ColorPacket, packet, intact, arrived);
}

void RawRecorder::addPacket(RawKind kind, std::span<const std::byte> packet, bool intact,
                            TimePoint arrived) {
    // What comes after a gap goes on with nothing before it.
    if (full_ && addStart() && add(RawKind::DepthPacket, {}, false, {}) &&
        add(RawKind::ColorPacket, {}, false, {}))
        full_ = false;
    if (!full_ && add(kind, packet, intact, arrived)) return;
    full_ = true;
    ++counters_.leftOut;
}

bool RawRecorder::hasRoom(std::size_t bytes) const {
    return counters_.error.empty() && !thread_.get_stop_token().stop_requested() &&
           waitingBytes_ + bytes <= mostBytes_;
}

bool RawRecorder::add(RawKind kind, std::span<const std::byte> payload, bool intact,
                      TimePoint arrived) {
    const std::size_t bytes = sizeof(RawHeader) + payload.size();
    if (payload.size() > kMostRawPayload || !hasRoom(bytes)) return false;
    if (waiting_.empty() || waiting_.back().size() + bytes > kChunkBytes) {
        waiting_.push_back(emptyChunk());
        changed_.notify_one();
    }
    const RawHeader header{0, kind, static_cast<std::uint32_t>(payload.size()), intact ? 1U : 0U,
                           arrived.time_since_epoch().count()};
    Chunk& chunk = waiting_.back();
    const auto head = std::as_bytes(std::span(&header, 1));
    chunk.insert(chunk.end(), head.begin(), head.end());
    chunk.insert(chunk.end(), payload.begin(), payload.end());
    waitingBytes_ += bytes;
    return true;
}

RawRecorder::Chunk RawRecorder::emptyChunk() {
    Chunk chunk;
    if (!used_.empty()) {
        chunk = std::move(used_.back());
        used_.pop_back();
        chunk.clear();
    }
    chunk.reserve(kChunkBytes);
    return chunk;
}

void RawRecorder::run(const std::stop_token& stop) {
    pthread_setname_np(pthread_self(), "kinect2-raw");
    for (;;) {
        Chunk chunk;
        {
            std::unique_lock lock(mutex_);
            // A full one, else what there is: a tenth of a second is lost with a killed program.
            changed_.wait_for(lock, stop, kLongest, [&] { return waiting_.size() > 1; });
            if (waiting_.empty() && stop.stop_requested()) return;
            if (waiting_.empty()) continue;
            chunk = std::move(waiting_.front());
            waiting_.pop_front();
        }
        if (!write(chunk)) return;
        const std::lock_guard lock(mutex_);
        waitingBytes_ -= chunk.size();
        if (used_.size() < kMostUsed) used_.push_back(std::move(chunk));
    }
}

bool RawRecorder::write(Chunk& chunk) {
    std::uint64_t records = 0;
    for (std::size_t at = 0; at < chunk.size(); ++records) {
        auto header = valueAt<RawHeader>(chunk, at);
        const auto payload =
            std::span<const std::byte>(chunk).subspan(at + sizeof header, header.payloadBytes);
        header.checksum = checksumOf(header, payload);
        std::memcpy(chunk.data() + at, &header.checksum, sizeof header.checksum);
        at += sizeof header + payload.size();
    }
    if (const int cause = writeAll(file_.get(), chunk); cause != 0) {
        end(cause);
        return false;
    }
    const std::lock_guard lock(mutex_);
    counters_.written += records;
    counters_.bytes += chunk.size();
    return true;
}

void RawRecorder::end(int cause) {
    const std::lock_guard lock(mutex_);
    counters_.error = refusal(path_, cause);
    spdlog::error("{}: the recording ends here", counters_.error);
    waiting_.clear();
    used_.clear();
}

} // namespace autostereo::devices::kinect2
