#include "devices/record/recorder.hpp"

#include "devices/record/payloads.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <utility>

namespace autostereo::devices {

namespace {

/// A stream that has nothing for so long keeps the other one waiting no longer.
constexpr Duration kLongestWait = std::chrono::milliseconds(500);
/// So long a stream may take to come up; the file's tracks are said at its start.
constexpr Duration kLongestStart = std::chrono::seconds(2);

} // namespace

Recorder::Recorder(const std::filesystem::path& file, RecordingHead head, WhenBehind whenBehind,
                   std::size_t mostBytes)
    : file_(file), whenBehind_(whenBehind), mostBytes_(mostBytes), head_(std::move(head)) {
    static_cast<void>(MatroskaWriter(file_, {})); // whether it can be written at all
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

Recorder::~Recorder() { finish(); }

void Recorder::finish() {
    thread_.request_stop();
    if (thread_.joinable()) thread_.join();
}

void Recorder::offer(Picture picture) {
    std::unique_lock lock(mutex_);
    const auto hasRoom = [&] {
        return waiting_.empty() || waitingBytes_ + picture.bytes() <= mostBytes_;
    };
    if (whenBehind_ == WhenBehind::Wait && !hasRoom()) {
        isFull_ = true;
        changed_.notify_all();
        changed_.wait(lock, [&] { return hasRoom() || !counters_.error.empty(); });
        isFull_ = false;
    }
    if (!hasRoom() || !counters_.error.empty()) {
        ++counters_.leftOut;
        return;
    }
    const TimePoint time = picture.form.capturedAt;
    forms_.try_emplace(picture.stream, picture.form);
    newest_[picture.stream] = time;
    waitingBytes_ += picture.bytes();
    waiting_.emplace(time, std::move(picture));
    changed_.notify_all();
}

Recorder::Counters Recorder::counters() const {
    const std::scoped_lock lock(mutex_);
    return counters_;
}

void Recorder::run(const std::stop_token& stop) {
    for (;;) {
        std::optional<Picture> picture;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, stop, [&] { return (picture = takeDue(isFull_)).has_value(); });
            if (!picture) picture = takeDue(true); // asked to stop
        }
        if (!picture) break;
        write(std::move(*picture));
    }
    if (!writer_) return;
    try {
        writer_->finish();
        const std::scoped_lock lock(mutex_);
        counters_.bytes = writer_->bytes();
    } catch (const RecordingError& error) {
        end(error.what());
    }
}

std::optional<Recorder::Picture> Recorder::takeDue(bool all) {
    if (waiting_.empty()) return std::nullopt;
    const TimePoint first = waiting_.begin()->first, last = waiting_.rbegin()->first;
    const bool allBeyond =
        newest_.size() == head_.streams &&
        std::ranges::all_of(newest_, [&](const auto& n) { return n.second >= first; });
    if (!all && !allBeyond && last - first < (writer_ ? kLongestWait : kLongestStart))
        return std::nullopt;
    Picture picture = std::move(waiting_.begin()->second);
    waiting_.erase(waiting_.begin());
    waitingBytes_ -= picture.bytes();
    changed_.notify_all();
    return picture;
}

void Recorder::begin(const Picture& first) {
    startedAt_ = first.form.capturedAt;
    RecordingLayout layout;
    layout.attachments = head_.attachments;
    layout.tags = {{"K4A_DEPTH_DELAY_NS", "0"},
                   {"K4A_WIRED_SYNC_MODE", "STANDALONE"},
                   {"K4A_START_OFFSET_NS", "0"}};
    {
        const std::scoped_lock lock(mutex_);
        if (const auto color = forms_.find(Stream::Color); color != forms_.end())
            layout.tracks.push_back(colorTrack(color->second, head_.period));
        if (const auto depth = forms_.find(Stream::Depth); depth != forms_.end()) {
            layout.tracks.push_back(depthTrack(depth->second, head_.period));
            if (depth->second.hasAmplitude)
                layout.tracks.push_back(infraredTrack(depth->second, head_.period));
        }
    }
    for (RecordingTrack& track : layout.tracks) {
        const unsigned number = static_cast<unsigned>(tracks_.size() + 1);
        tracks_[track.name] = number;
        track.tags.emplace_back("K4A_" + track.name + "_TRACK", std::to_string(number));
    }
    writer_ = std::make_unique<MatroskaWriter>(file_, layout);
}

void Recorder::write(Picture picture) {
    bool kept = false;
    try {
        if (!writer_) begin(picture); // after an end nothing is waiting
        const FrameMetadata& form = picture.form;
        if (picture.stream == Stream::Color) {
            kept = append("COLOR", form, colorPayload(form, std::move(picture.sent)));
        } else {
            kept = append("DEPTH", form, countsPayload(std::move(picture.sent)));
            if (form.hasAmplitude)
                kept &= append("IR", form, countsPayload(std::move(picture.infrared)));
        }
    } catch (const RecordingError& failed) {
        end(failed.what());
    } catch (const std::exception& odd) {
        spdlog::debug("{}: a picture is left out: {}", file_.string(), odd.what());
    }
    const std::scoped_lock lock(mutex_);
    if (writer_) counters_.bytes = writer_->bytes();
    ++(kept ? counters_.written : counters_.leftOut);
}

bool Recorder::append(const char* track, const FrameMetadata& form,
                      std::span<const std::byte> payload) {
    const auto number = tracks_.find(track);
    if (number == tracks_.end()) return false; // it came after the file was begun
    writer_->write(number->second, form.capturedAt - startedAt_, payload);
    return true;
}

void Recorder::end(const std::string& error) {
    spdlog::error("{}: the recording ends here", error);
    writer_.reset();
    const std::scoped_lock lock(mutex_);
    counters_.error = error;
    counters_.leftOut += waiting_.size();
    waiting_.clear();
    waitingBytes_ = 0;
    changed_.notify_all();
}

} // namespace autostereo::devices
