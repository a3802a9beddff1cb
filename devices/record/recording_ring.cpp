#include "devices/record/recording_ring.hpp"

#include "devices/record/recorder.hpp"
#include "devices/unique_fd.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include <sys/mman.h>
#include <unistd.h>

namespace autostereo::devices {

namespace {

constexpr std::size_t kOnTheWay = std::size_t{16} << 20U; // beside what the ring holds

std::vector<std::uint8_t> bytesIn(int fd) {
    const off_t size = ::lseek(fd, 0, SEEK_END);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(std::max<off_t>(size, 0)));
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t count =
            ::pread(fd, bytes.data() + at, bytes.size() - at, static_cast<off_t>(at));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) throw RecordingError("recording: cannot be read back from memory");
        at += static_cast<std::size_t>(count);
    }
    return bytes;
}

} // namespace

void RecordingRing::begin(RecordingHead head) {
    const std::scoped_lock lock(mutex_);
    head_ = std::move(head);
    pictures_.clear();
    bytes_ = 0;
}

void RecordingRing::offer(RecordedStream stream, const Frame& frame) {
    auto picture = std::make_shared<const RecordedPicture>(copyOf(stream, frame));
    const TimePoint now = picture->form.capturedAt;
    // Held by a moment that lies ahead, too: a clock that was set back.
    const auto isOut = [&](const RecordedPicture& other) {
        const TimePoint then = other.form.capturedAt;
        return then + params_.length < now || then > now + params_.length;
    };
    const std::scoped_lock lock(mutex_);
    bytes_ += picture->bytes();
    pictures_.push_back(std::move(picture));
    while (!pictures_.empty() && (bytes_ > params_.mostBytes || isOut(*pictures_.front()))) {
        bytes_ -= pictures_.front()->bytes();
        pictures_.pop_front();
    }
}

RecordingRing::Held RecordingRing::held() const {
    Held held;
    {
        const std::scoped_lock lock(mutex_);
        held = {head_, {pictures_.begin(), pictures_.end()}};
    }
    std::ranges::stable_sort(held.pictures, {},
                             [](const auto& picture) { return picture->form.capturedAt; });
    return held;
}

void writeRecording(const RecordingRing::Held& held, const std::filesystem::path& file) {
    Recorder recorder(file, held.head, Recorder::WhenBehind::Wait, kOnTheWay);
    for (const auto& picture : held.pictures)
        recorder.offer(*picture);
    recorder.finish();
    if (const auto error = recorder.counters().error; !error.empty()) throw RecordingError(error);
}

std::vector<std::uint8_t> recordingOf(const RecordingRing::Held& held) {
    const UniqueFd memory(::memfd_create("autostereo-recording", MFD_CLOEXEC));
    if (!memory)
        throw RecordingError(std::string("recording: no memory for it: ") + std::strerror(errno));
    writeRecording(held, "/proc/self/fd/" + std::to_string(memory.get()));
    return bytesIn(memory.get());
}

} // namespace autostereo::devices
