#include "tests/device/kinect2/kinect2_fixture.hpp"

#include "devices/kinect2/usb/find_units.hpp"
#include "devices/kinect2/usb/unit_sources.hpp"
#include "devices/replay/jpeg_decoder.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include <execinfo.h>
#include <unistd.h>

namespace autostereo::test {

using namespace devices::kinect2;

namespace {

/// Row by row from the other end.
template<class T, class Get>
std::vector<T> turned(int width, int height, const Get& get) {
    std::vector<T> result;
    for (int y = 0; y < height; ++y)
        for (int x = width; x-- > 0;)
            result.push_back(get(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                 static_cast<std::size_t>(x)));
    return result;
}

ExpectedPictures makeExpected() {
    ExpectedPictures expected;
    const Kinect2Show show = stairsShow(30);
    const PhaseDecoder decoder(parsePhasePage(phasePage(show.unit)),
                               parseDepthCameraPage(depthCameraPage(show.unit)));
    for (const RawDepthFrame& exposure : show.exposures) {
        DepthPicture picture;
        decoder.decode(exposure, picture);
        const auto count = [&](std::size_t i) {
            return static_cast<std::uint16_t>(
                std::lround(picture.depthMm[i] * 0.001 / kDepthUnitM));
        };
        expected.depth.push_back(turned<std::uint16_t>(kWidth, kHeight, count));
        expected.infrared.push_back(turned<std::uint16_t>(
            kWidth, kHeight, [&](std::size_t i) { return picture.infrared[i]; }));
    }
    devices::JpegDecoder jpeg;
    for (const usbip::Bytes& bytes : show.jpegs) {
        const auto all = std::as_bytes(std::span(bytes));
        expected.jpegs.emplace_back(all.begin(), all.end());
        std::vector<std::byte> pixels(jpeg.open(std::as_bytes(std::span(bytes))).bytes());
        jpeg.decode(pixels);
        std::vector<std::byte> right;
        right.reserve(pixels.size());
        for (std::size_t y = 0; y < 1080; ++y)
            for (std::size_t x = 1920; x-- > 0;)
                for (std::size_t sample = 0; sample < 4; ++sample)
                    right.push_back(pixels[(y * 1920 + x) * 4 + sample]);
        expected.color.push_back(std::move(right));
    }
    return expected;
}

template<class Pictures, class Picture, class Same>
std::optional<std::size_t> position(const Pictures& pictures, const Picture& picture,
                                    const Same& same) {
    for (std::size_t i = 0; i < pictures.size(); ++i)
        if (same(pictures[i], picture)) return i;
    return std::nullopt;
}

} // namespace

const ExpectedPictures& expectedPictures() {
    static const ExpectedPictures kExpected = makeExpected();
    return kExpected;
}

std::optional<std::size_t> ExpectedPictures::find(const devices::Frame& frame) const {
    if (frame.metadata().format != devices::PixelFormat::Depth16) {
        // Filler may follow what was sent.
        const auto sent = position(jpegs, frame.encoded(), [&](const auto& jpeg, auto bytes) {
            return std::ranges::equal(jpeg, bytes.first(std::min(jpeg.size(), bytes.size())));
        });
        const std::size_t row = 1920 * 4;
        for (std::size_t at = 0; sent && at < frame.pixels().size(); at += 13 * row)
            if (!std::ranges::equal(frame.pixels().subspan(at, row),
                                    std::span(color[*sent]).subspan(at, row)))
                return std::nullopt;
        return sent;
    }
    // Half counts may be rounded either way: the source counts in floats.
    const auto near = [](const auto& all, const auto& counts) {
        return std::ranges::equal(
            all, counts, [](std::uint16_t a, std::uint16_t b) { return std::abs(a - b) <= 1; });
    };
    const auto found = position(depth, frame.depth(), near);
    if (!found || !std::ranges::equal(infrared[*found], frame.amplitude())) return std::nullopt;
    return found;
}

namespace {

/// What decoding a pair takes here, the median of nine. 12 on an idle machine.
double decodeMs() {
    const Kinect2Show show = stairsShow(30);
    const PhaseDecoder decoder(parsePhasePage(phasePage(show.unit)),
                               parseDepthCameraPage(depthCameraPage(show.unit)));
    devices::JpegDecoder jpeg;
    DepthPicture picture;
    std::vector<std::byte> pixels(std::size_t{1920} * 1080 * 4);
    std::vector<double> times;
    for (int i = 0; i < 9; ++i) {
        const auto started = std::chrono::steady_clock::now();
        decoder.decode(show.exposures[0], picture);
        static_cast<void>(jpeg.open(std::as_bytes(std::span(show.jpegs[0]))));
        jpeg.decode(pixels);
        times.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - started)
                .count());
    }
    std::ranges::sort(times);
    return times[times.size() / 2];
}

} // namespace

double possibleFps() {
    const double took = decodeMs(), most = 500 / took;
    std::printf("decoding one pair takes %.1f ms\n", took);
    return most > 30 ? 30.0 : most > 15 ? 15.0 : most > 7.5 ? 7.5 : 4.0;
}

bool holdThread(const std::string& name, std::chrono::milliseconds time) {
    static std::atomic<long> milliseconds{0};
    struct sigaction hold {};
    hold.sa_handler = [](int) {
        const int error = errno;
        const long left = milliseconds.load();
        const timespec pause{left / 1000, left % 1000 * 1'000'000};
        nanosleep(&pause, nullptr);
        errno = error;
    };
    hold.sa_flags = SA_RESTART;
    milliseconds = static_cast<long>(time.count());
    sigaction(SIGUSR1, &hold, nullptr);
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
        std::string comm;
        std::getline(std::ifstream(task.path() / "comm"), comm);
        if (comm == name)
            return tgkill(getpid(), std::stoi(task.path().filename().string()), SIGUSR1) == 0;
    }
    return false;
}

namespace {

/// A guest leaves no core behind.
void sayWhereItCrashes() {
    struct sigaction crash {};
    crash.sa_handler = [](int signal) {
        std::array<void*, 48> frames{};
        backtrace_symbols_fd(frames.data(), backtrace(frames.data(), frames.size()), 2);
        std::signal(signal, SIG_DFL);
        raise(signal);
    };
    for (const int signal : {SIGSEGV, SIGBUS, SIGABRT})
        sigaction(signal, &crash, nullptr);
}

} // namespace

void Kinect2Test::SetUpTestSuite() {
    sayWhereItCrashes();
    // What both streams hold at their fullest. First touched while a camera streams, at 0.2 ms a
    // page in a guest (see guest/run.sh), it would cost the first three seconds of pictures.
    if (!usbip::Plug::possible()) return;
    constexpr std::size_t kBlocks = 10, kBlockBytes = std::size_t{10} << 20U;
    std::vector<std::vector<std::byte>> touched;
    for (std::size_t i = 0; i < kBlocks; ++i)
        touched.emplace_back(kBlockBytes);
}

namespace {

bool hasNode() {
    const auto units = findUnits();
    return !units.empty() && std::filesystem::exists(units.front().node);
}

} // namespace

void Kinect2Test::plugIn(double fps) {
    camera.emplace(stairsShow(fps));
    plugInAgain();
}

void Kinect2Test::plugInAgain() {
    constexpr int kTries = 3;
    for (int i = 0; i < kTries; ++i) {
        plug.reset();
        camera->powerUp();
        plug = std::make_unique<usbip::Plug>(*camera, usbip::Speed::Super);
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(3);
        for (; std::chrono::steady_clock::now() < end;
             std::this_thread::sleep_for(std::chrono::milliseconds(5)))
            if (hasNode()) return;
        // A virtual port may reject its first requests while it still lets the last device go.
        std::printf("the kernel did not take the camera; it is plugged in again\n");
    }
    FAIL() << "the kernel does not take the camera";
}

void Kinect2Test::setFaults(const usbip::Faults& depth, const usbip::Faults& color) {
    plug->setFaults(Kinect2Camera::kDepth, depth);
    plug->setFaults(Kinect2Camera::kColor, color);
}

devices::Frame nextFrame(devices::Source& source, std::string* why,
                         std::chrono::milliseconds patience) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < end) {
        auto result = source.read(end);
        if (auto* frame = std::get_if<devices::Frame>(&result)) return std::move(*frame);
        const auto* gone = std::get_if<devices::Disconnected>(&result);
        if (gone == nullptr) continue;
        if (why != nullptr) *why = gone->reason;
        break;
    }
    return {};
}

} // namespace autostereo::test
