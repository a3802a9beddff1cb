#include "devices/openni2/oni_file.hpp"

#include "devices/frame_pool.hpp"
#include "devices/openni2/oni_wire.hpp"
#include "devices/openni2/pinhole.hpp"
#include "devices/unique_fd.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace autostereo::devices::openni2 {

namespace {

constexpr int kPatienceMs = 10'000; // a reader that says nothing for so long hangs

/// Beside the program, or where it is installed; AUTOSTEREO_ONI_READER names another.
std::filesystem::path readerProgram() {
    constexpr const char* kName = "autostereo-oni-reader";
    if (const char* other = std::getenv("AUTOSTEREO_ONI_READER")) return other;
    std::error_code error;
    const auto own = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    for (const auto& folder : {own, own / "../devices", own / "../libexec/autostereo"})
        if (std::filesystem::exists(folder / kName, error)) return folder / kName;
    throw DeviceError(std::string(kName) + " is not installed beside " + own.string());
}

/// The process that reads, and the pipe on which its frames come.
class Reader {
  public:
    Reader(const std::filesystem::path& file, const char* stream) {
        const std::string program = readerProgram().string(), name = file.string();
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) != 0) throw DeviceError("cannot make a pipe for " + name);
        pipe_ = UniqueFd(ends[0]);
        const UniqueFd theirs(ends[1]);
        posix_spawn_file_actions_t actions;
        posix_spawn_file_actions_init(&actions);
        posix_spawn_file_actions_adddup2(&actions, theirs.get(), STDOUT_FILENO);
        std::string words[] = {program, name, stream};
        char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
        const int failed =
            posix_spawn(&process_, program.c_str(), &actions, nullptr, arguments, environ);
        posix_spawn_file_actions_destroy(&actions);
        if (failed != 0) throw DeviceError("cannot start " + program);
    }
    ~Reader() {
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    /// All of `bytes`, or false: the process ended, broke or hangs.
    [[nodiscard]] bool read(std::span<std::byte> bytes) { return readMost(bytes) == bytes.size(); }
    template<class Header>
    [[nodiscard]] bool readHeader(Header& header) {
        return read(std::as_writable_bytes(std::span(&header, 1))) &&
               header.magic == Header::kMagic;
    }
    /// Why there is no stream, if there is none: what the process says instead of its header.
    [[nodiscard]] std::optional<std::string> begin(OniStreamHeader& header) {
        std::array<char, 400> said{};
        const auto all = std::as_writable_bytes(std::span(said));
        const std::size_t first = readMost(all.first(sizeof header));
        std::memcpy(&header, said.data(), sizeof header);
        if (first == sizeof header && header.magic == OniStreamHeader::kMagic) return std::nullopt;
        if (first == sizeof header) static_cast<void>(readMost(all.subspan(first)));
        const std::string_view line(said.data(), strnlen(said.data(), said.size()));
        return line.empty() ? "the reader ended without a word"
                            : std::string(line.substr(0, line.find('\n')));
    }

  private:
    /// How many bytes came before the process ended, broke or hung.
    [[nodiscard]] std::size_t readMost(std::span<std::byte> bytes) {
        std::size_t count = 0;
        while (count < bytes.size()) {
            pollfd waiting{pipe_.get(), POLLIN, 0};
            const int ready = poll(&waiting, 1, kPatienceMs);
            if (ready < 0 && errno == EINTR) continue;
            if (ready <= 0) break;
            const ssize_t got = ::read(pipe_.get(), bytes.data() + count, bytes.size() - count);
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) break;
            count += static_cast<std::size_t>(got);
        }
        return count;
    }

    UniqueFd pipe_;
    pid_t process_ = -1;
};

/// One stream of a recording.
class OniSource final : public Source {
  public:
    OniSource(std::filesystem::path file, const char* stream)
        : file_(std::move(file)), stream_(stream) {
        start();
    }

    [[nodiscard]] ReadResult read(TimePoint) noexcept override {
        OniFrameHeader header;
        if (ended_ || !reader_->readHeader(header)) return end();
        FrameMetadata metadata;
        metadata.format = static_cast<PixelFormat>(shape_.format);
        metadata.width = shape_.width;
        metadata.height = shape_.height;
        metadata.sequence = next_++;
        metadata.capturedAt = TimePoint(Duration(header.capturedAtNs));
        metadata.depthUnitM = shape_.depthUnitM;
        metadata.hasAmplitude = header.hasAmplitude == 1;
        auto frame = pool_.acquire(metadata);
        if (!frame) {
            spare_.resize(frameBytes(metadata.format, metadata.width, metadata.height) *
                          (metadata.hasAmplitude ? 2 : 1));
            ++counters_.starved;
            return reader_->read(spare_) ? ReadResult(Timeout{}) : end();
        }
        if (!reader_->read(frame->pixels()) ||
            !reader_->read(std::as_writable_bytes(frame->amplitude())))
            return end();
        ++counters_.delivered;
        return std::move(*frame);
    }
    [[nodiscard]] bool rewind() noexcept override try {
        start();
        return true;
    } catch (const std::exception& error) {
        spdlog::warn("{}", error.what());
        return false;
    }
    [[nodiscard]] SourceCounters counters() const noexcept override { return counters_; }
    [[nodiscard]] const OniStreamHeader& shape() const { return shape_; }

  private:
    void start() {
        constexpr int kLargest = 8192;
        reader_ = std::make_unique<Reader>(file_, stream_);
        next_ = 0;
        ended_ = false;
        const auto why = reader_->begin(shape_);
        const auto inside = [](int side) { return side >= 1 && side <= kLargest; };
        if (why || !inside(shape_.width) || !inside(shape_.height) || shape_.frames < 1)
            throw DeviceError(file_.string() + ": no " + stream_ +
                              " can be read from it (damaged, " + "empty, or no OpenNI2 recording" +
                              (why ? ": " + *why : "") + ")");
    }
    ReadResult end() {
        if (!ended_ && next_ < static_cast<std::uint64_t>(shape_.frames))
            spdlog::warn("{}: {} ends after {} of {} frames: damaged there", file_.string(),
                         stream_, next_, shape_.frames);
        ended_ = true;
        return Ended{};
    }

    std::filesystem::path file_;
    const char* stream_;
    std::unique_ptr<Reader> reader_;
    OniStreamHeader shape_;
    FramePool pool_{kFramesOnTheWay};
    std::vector<std::byte> spare_;
    std::uint64_t next_ = 0;
    bool ended_ = false;
    SourceCounters counters_;
};

/// A stream that may be missing: then none, and why.
std::unique_ptr<OniSource> openStream(const std::filesystem::path& path, const char* stream,
                                      std::string& whyNot) try {
    return std::make_unique<OniSource>(path, stream);
} catch (const DeviceError& error) {
    whyNot = error.what();
    return nullptr;
}

calib::CameraModel cameraOf(const OniStreamHeader& shape) {
    return pinhole(shape.width, shape.height, shape.horizontalFov, shape.verticalFov);
}

} // namespace

Input openOniFile(const std::filesystem::path& path, const std::optional<calib::SensorRig>& rig) {
    Input input;
    input.uri = path.string();
    input.description = "OpenNI2 recording";
    std::string missing;
    auto depth = openStream(path, "depth", missing);
    auto color = openStream(path, "color", missing);
    if (!depth && !color) throw DeviceError(missing);
    if (!missing.empty()) spdlog::info("{}", missing);
    calib::SensorRig nominal;
    nominal.provenance = "the fields of view in the recording";
    for (const auto& [source, name] : {std::pair{depth.get(), "depth"}, {color.get(), "colour"}}) {
        if (source == nullptr) continue;
        const OniStreamHeader& shape = source->shape();
        input.description +=
            ", " + std::to_string(shape.width) + "x" + std::to_string(shape.height) + " " + name;
        if (shape.fps > 0)
            input.nominalPeriod = std::chrono::nanoseconds(1'000'000'000) / shape.fps;
    }
    constexpr double kCoarse = 5e-4;
    if (depth && depth->shape().depthUnitM < kCoarse)
        input.warnings.push_back(input.uri + ": depth in steps of 0.1 mm: OpenNI2's recorder "
                                             "damages frames of more than 32768 different depths "
                                             "without a word (record with 1 mm)");
    if (depth) nominal.depth = cameraOf(depth->shape());
    if (color) nominal.color = cameraOf(color->shape());
    input.rig = rig ? *rig : nominal;
    if (!rig)
        input.warnings.push_back(input.uri + ": cameras are taken as pinholes in one place, as the "
                                             "recording knows no more; give --rig");
    input.depth = std::move(depth);
    input.color = std::move(color);
    return input;
}

} // namespace autostereo::devices::openni2
