// A Kinect v2 on USB: what comes out is what the camera saw.

#include "devices/kinect2/usb/unit_sources.hpp"
#include "devices/record/recording_source.hpp"
#include "tests/device/kinect2/kinect2_fixture.hpp"
#include "tests/support/data.hpp"
#include "tests/support/scratch_folder.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <thread>

namespace autostereo::test {
namespace {

using namespace std::chrono_literals;

TEST_F(Kinect2Test, ShowsWhatStandsBeforeIt) {
    plugIn();
    const devices::Input input = devices::openInput("kinect2:");
    EXPECT_TRUE(input.description.starts_with("Kinect v2 000001234567, firmware 4.0.3903"))
        << input.description;
    EXPECT_TRUE(input.warnings.empty()) << input.warnings.front();
    std::string why;
    const devices::Frame frame = nextFrame(*input.depth, &why);
    ASSERT_FALSE(frame.empty()) << why;
    const auto exposure = expectedPictures().find(frame);
    ASSERT_TRUE(exposure);
    // The camera's picture is mirrored: its column x is ours counted from the right.
    double worst = 0;
    for (int y = 0; y < 424; ++y)
        for (int x = 1; x < 511; ++x) {
            const auto pixel = static_cast<std::size_t>(y * 512 + 511 - x);
            const double depth = frame.depth()[pixel] * frame.metadata().depthUnitM * 1000;
            worst = std::max(worst, std::abs(depth - showedPoint(*exposure, x, y).depthMm));
        }
    // 1.7 mm: eleven bits; 0.15: half a step of the frame's.
    EXPECT_LE(worst, 1.85);
    const devices::Frame color = nextFrame(*input.color, &why);
    ASSERT_FALSE(color.empty()) << why;
    EXPECT_TRUE(expectedPictures().find(color));
}

TEST_F(Kinect2Test, RecordsWhatItShows) {
    plugIn(5);
    const ScratchFolder folder;
    const std::filesystem::path file = folder / "kinect.mkv";
    {
        devices::Input live = devices::openInput("kinect2:");
        auto recorder = std::make_shared<devices::Recorder>(
            file, live, devices::Recorder::WhenBehind::LeaveOut);
        live = devices::recorded(std::move(live), recorder);
        for (int i = 0; i < 4; ++i) {
            ASSERT_FALSE(nextFrame(*live.depth).empty());
            ASSERT_FALSE(nextFrame(*live.color).empty());
        }
        recorder->finish();
        EXPECT_EQ(recorder->counters().written, 8U);
    }
    const devices::Input again = devices::openInput(file.string());
    EXPECT_NEAR(again.rig->colorFromDepth.translation.x, -0.05, 0.01)
        << "the colour camera is on the right";
    const ExpectedPictures& expected = expectedPictures();
    for (int i = 0; i < 4; ++i) {
        const devices::Frame depth = nextFrame(*again.depth), color = nextFrame(*again.color);
        ASSERT_FALSE(depth.empty() || color.empty());
        EXPECT_TRUE(expected.find(depth)) << i;
        EXPECT_FALSE(color.metadata().encodedMirrored);
        // Turned without loss; chroma between samples may be rounded the other way.
        double best = 255;
        for (const auto& picture : expected.color) {
            double sum = 0;
            for (std::size_t at = 0; at < picture.size(); at += 41)
                sum += std::abs(std::to_integer<int>(picture[at]) -
                                std::to_integer<int>(color.pixels()[at]));
            best = std::min(best, sum * 41 / static_cast<double>(picture.size()));
        }
        EXPECT_LE(best, 1) << i;
    }
}

/// All that a frame holds.
std::vector<std::byte> bytesOf(const devices::Frame& frame) {
    std::vector<std::byte> all;
    for (const auto part :
         {std::span<const std::byte>(frame.pixels()), std::as_bytes(std::span(frame.amplitude())),
          std::span<const std::byte>(frame.encoded())})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

/// How many frames come within a number of reads, and which pictures they are.
struct Shown {
    std::size_t frames = 0;
    std::set<std::vector<std::byte>> pictures;

    void add(const devices::Frame& frame) {
        if (frame.empty()) return;
        ++frames;
        pictures.insert(bytesOf(frame));
    }
};

TEST_F(Kinect2Test, WhatItSendsIsRecordedBelowTheDecoder) {
    plugIn(5);
    const ScratchFolder folder;
    const std::string file = folder / "kinect.raw";
    Shown depths, colors;
    {
        const devices::Input live = devices::openInput("kinect2:");
        const auto recording = live.recordRaw(file);
        usbip::Faults faults;
        faults.lose = 0.002; // every fifth frame
        setFaults(faults, {});
        for (int i = 0; i < 12; ++i) {
            depths.add(nextFrame(*live.depth));
            colors.add(nextFrame(*live.color));
        }
        recording->finish();
        EXPECT_EQ(recording->counters().error, "");
        EXPECT_EQ(recording->counters().leftOut, 0U);
        std::printf("%llu records, %.1f MB\n",
                    static_cast<unsigned long long>(recording->counters().written),
                    static_cast<double>(recording->counters().bytes) * 1e-6);
    }
    const devices::Input again = devices::openInput(file);
    Shown depthsAgain, colorsAgain;
    for (auto [source, shown] :
         {std::pair{again.depth.get(), &depthsAgain}, std::pair{again.color.get(), &colorsAgain}})
        for (devices::Frame frame; !(frame = nextFrame(*source, nullptr, 500ms)).empty();)
            shown->add(frame);
    // The first frame was on its way when the recording began, perhaps, and a last one may not
    // have been read any more.
    EXPECT_GE(depthsAgain.frames + 1, depths.frames);
    EXPECT_GE(colorsAgain.frames + 1, colors.frames);
    EXPECT_EQ(depthsAgain.pictures, depths.pictures);
    EXPECT_EQ(colorsAgain.pictures, colors.pictures);
    EXPECT_GT(again.depth->counters().damaged, 0U) << "faults are recorded, too";
}

/// CPU time of this process's threads of that name, seconds.
double cpuSeconds(const std::string& thread) {
    double ticks = 0;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
        std::ifstream file(task.path() / "stat");
        std::string line;
        std::getline(file, line);
        if (line.find("(" + thread + ")") == std::string::npos) continue;
        std::istringstream rest(line.substr(line.rfind(')') + 2));
        std::string field;
        for (int i = 3; i <= 15 && rest >> field; ++i)
            if (i >= 14) ticks += std::stod(field);
    }
    return ticks / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double milliseconds(std::chrono::nanoseconds time) {
    return std::chrono::duration<double, std::milli>(time).count();
}

/// Reads one stream on a thread of its own and looks at every frame.
class Reader {
  public:
    struct Seen {
        unsigned good = 0, misread = 0, gaps = 0;
        std::vector<double> intervalsMs, lagsMs;
        std::string lost;
        devices::SourceCounters counters;
        std::uint64_t underruns = 0; ///< of depth, as the source noticed them
    };

    Reader(const char* name, std::unique_ptr<devices::Source> source)
        : source_(std::move(source)),
          thread_([this, name](const std::stop_token& stop) { run(name, stop); }) {}
    /// Since the last time.
    [[nodiscard]] Seen take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(seen_, {});
    }

  private:
    void run(const char* name, const std::stop_token& stop) {
        pthread_setname_np(pthread_self(), name);
        std::string lost;
        while (!stop.stop_requested() && lost.empty()) {
            const devices::Frame frame = nextFrame(*source_, &lost, 50ms);
            const bool good = !frame.empty() && expectedPictures().find(frame);
            const std::lock_guard lock(mutex_);
            seen_.lost = lost;
            seen_.counters = source_->counters();
            if (const auto* depth = dynamic_cast<devices::kinect2::DepthSource*>(source_.get()))
                seen_.underruns = depth->unitCounters().depthUnderruns;
            if (!frame.empty()) note(frame.metadata(), good);
        }
    }
    void note(const devices::FrameMetadata& now, bool good) {
        ++(good ? seen_.good : seen_.misread);
        seen_.lagsMs.push_back(milliseconds(std::chrono::steady_clock::now() - now.capturedAt));
        if (last_) {
            seen_.gaps += static_cast<unsigned>(now.sequence - last_->sequence - 1);
            seen_.intervalsMs.push_back(milliseconds(now.capturedAt - last_->capturedAt));
        }
        last_ = now;
    }
    std::unique_ptr<devices::Source> source_;
    std::mutex mutex_;
    Seen seen_; ///< under mutex_
    std::optional<devices::FrameMetadata> last_;
    std::jthread thread_; // last: it uses all of the above
};

void print(const char* name, Reader::Seen& seen, unsigned sent, double cpu) {
    ASSERT_FALSE(seen.intervalsMs.empty()) << seen.lost;
    std::ranges::sort(seen.intervalsMs);
    std::ranges::sort(seen.lagsMs);
    const auto middle = [](const std::vector<double>& all) { return all[all.size() / 2]; };
    std::printf("%s: %u sent, %u read, %u wrong, %u not read, %llu damaged; interval %.2f / %.2f / "
                "%.2f ms; "
                "lag from mid-exposure %.1f ms median, %.1f most; CPU %.3f\n",
                name, sent, seen.good, seen.misread, seen.gaps,
                static_cast<unsigned long long>(seen.counters.damaged), seen.intervalsMs.front(),
                middle(seen.intervalsMs), seen.intervalsMs.back(), middle(seen.lagsMs),
                seen.lagsMs.back(), cpu);
}

TEST_F(Kinect2Test, FullRateBreaksNothing) {
    static_cast<void>(expectedPictures());
    plugIn();
    devices::Input input = devices::openInput("kinect2:");
    Reader depth("kin-depth", std::move(input.depth)), color("kin-color", std::move(input.color));
    std::this_thread::sleep_for(1s); // until every slot of the pools has its memory
    const std::uint64_t noticedBefore = depth.take().underruns;
    const unsigned underrunsBefore = camera->underruns(), cutBefore = camera->depthFramesCut();
    static_cast<void>(color.take());
    const std::array<const char*, 3> threads{"kinect2-usb", "kin-depth", "kin-color"};
    std::array<double, 3> cpu{};
    const unsigned depthBefore = camera->depthFramesSent();
    const unsigned colorBefore = camera->colorFramesSent();
    for (std::size_t i = 0; i < cpu.size(); ++i)
        cpu[i] = -cpuSeconds(threads[i]);
    const auto duration = fullCampaign() ? 60s : 5s;
    std::this_thread::sleep_for(duration);
    for (std::size_t i = 0; i < cpu.size(); ++i)
        cpu[i] =
            (cpu[i] + cpuSeconds(threads[i])) / std::chrono::duration<double>(duration).count();
    const unsigned depthSent = camera->depthFramesSent() - depthBefore;
    const unsigned colorSent = camera->colorFramesSent() - colorBefore;
    Reader::Seen depths = depth.take(), colors = color.take();

    std::printf("%.1f fps, %u frames cut, %u underruns, of which the reader noticed %llu; CPU of "
                "the thread at the bus %.3f\n",
                camera->show().fps, camera->depthFramesCut() - cutBefore,
                camera->underruns() - underrunsBefore,
                static_cast<unsigned long long>(depths.underruns - noticedBefore), cpu[0]);
    print("kin-depth", depths, depthSent, cpu[1]);
    print("kin-color", colors, colorSent, cpu[2]);
    EXPECT_EQ(depths.lost + colors.lost, "");
    EXPECT_EQ(depths.misread, 0U);
    EXPECT_EQ(colors.misread, 0U);
    EXPECT_EQ(colors.counters.damaged, 0U);
    // One processor is camera, kernel and reader. Where other programs take it away, the host lets
    // intervals pass; one more for a frame that is on its way.
    // Nor is a frame given out of which a transfer came so late that packets may be missing.
    EXPECT_LE(depths.counters.damaged, camera->depthFramesCut() + depths.underruns + 1);
    // Every frame that was sent was read or is missed by its number, but for those on their way at
    // either end. A camera without a processor leaves numbers out.
    const auto onTheirWay = [&](const Reader::Seen& seen) {
        const double lagFrames = seen.lagsMs.back() / 1e3 * camera->show().fps;
        return 2 * (1 + static_cast<unsigned>(std::ceil(lagFrames)));
    };
    EXPECT_GE(depths.good + depths.gaps + onTheirWay(depths), depthSent);
    EXPECT_GE(colors.good + colors.gaps + onTheirWay(colors), colorSent);
    // A processor of its own loses nothing; nobody measures on one that was taken away.
    if (camera->depthFramesCut() == 0 && depths.gaps + colors.gaps < depthSent / 10) {
        EXPECT_LE(depths.gaps, 1 + depthSent / 50);
        EXPECT_LE(colors.gaps, 1 + colorSent / 20);
    }
}

} // namespace
} // namespace autostereo::test
