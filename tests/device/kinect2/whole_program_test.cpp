// From the camera's raw phases on the bus to the panel that the program shows, against double
// precision.

#include "config/load.hpp"
#include "daemon/wiring.hpp"
#include "devices/kinect2/mirror.hpp"
#include "devices/kinect2/registration.hpp"
#include "devices/kinect2/usb/unit_sources.hpp"
#include "devices/replay/image_files.hpp"
#include "tests/device/kinect2/kinect2_fixture.hpp"
#include "tests/oracle/panel_differences.hpp"
#include "tests/support/data.hpp"
#include "tests/support/gl_fixture.hpp"
#include "tests/support/gl_scene.hpp"
#include "tests/support/gl_search_input.hpp"
#include "tests/support/run_program.hpp"
#include "tests/support/scratch_folder.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include <sys/mount.h>

namespace autostereo::test {
namespace {

using namespace devices::kinect2;

constexpr const char* kConfig = R"([depth]
follow = "never"
)";
constexpr const char* kDisplay = R"(base = "slanted-8view-1080p"
[panel]
width = 480
height = 270
)";

/// What the source has to make of the first exposure and JPEG, without any bus.
devices::RgbdFrame expectedPair(devices::FramePool& pool) {
    const ExpectedPictures& expected = expectedPictures();
    devices::RgbdFrame pair;
    devices::FrameMetadata form;
    form.format = devices::PixelFormat::Depth16;
    form.width = kWidth;
    form.height = kHeight;
    form.depthUnitM = kDepthUnitM;
    form.hasAmplitude = true;
    pair.depth = *pool.acquire(form);
    std::ranges::copy(expected.depth[0], pair.depth.depth().begin());
    std::ranges::copy(expected.infrared[0], pair.depth.amplitude().begin());
    form = {};
    form.width = kColorWidth;
    form.height = kColorHeight;
    pair.color = *pool.acquire(form);
    std::ranges::copy(expected.color[0], pair.color.pixels().begin());
    return pair;
}

gpu::RgbImage readPanel(const std::string& file) {
    devices::ImageReader reader;
    const devices::ImageHeader header = reader.open(file);
    std::vector<std::byte> rgba(header.bytes());
    reader.decode(rgba);
    gpu::RgbImage image{header.width, header.height, {}};
    for (std::size_t i = 0; i < rgba.size(); ++i)
        if (i % 4 != 3) image.pixels.push_back(std::to_integer<std::uint8_t>(rgba[i]));
    return image;
}

TEST_F(Kinect2Test, TheProgramShowsWhatStandsBeforeTheCamera) {
    Kinect2Show show = stairsShow(5);
    show.exposures.resize(1); // a still picture: the program draws it once
    show.jpegs.resize(1);
    camera.emplace(show);
    plugInAgain();
    const ScratchFolder folder;
    const std::string display = folder.write("small.toml", kDisplay);
    ProgramCall call;
    call.program = AUTOSTEREO_PROGRAM;
    call.arguments = {"run",
                      "--input",
                      "kinect2:",
                      "--config",
                      folder.write("c.toml", kConfig),
                      "--display",
                      display,
                      "--output",
                      "offscreen",
                      "--frames",
                      "1",
                      "--snapshot",
                      folder / "panel.png"};
    call.environment = {"DISPLAY=", "WAYLAND_DISPLAY="};
    const ProgramResult result = runProgram(call);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const gpu::RgbImage image = readPanel(folder / "panel.png");
    plug.reset();

    const gpu::gl::SurfacelessContext context(true);
    daemon::SceneOptions options;
    options.config = folder / "c.toml";
    const calib::DisplayProfile profile = config::loadDisplay(display);
    const calib::SensorRig rig = mirrored(fitRig(parseColorPage(colorPage(show.unit)),
                                                 parseDepthCameraPage(depthCameraPage(show.unit)))
                                              .rig);
    gpu::Pipeline pipeline(daemon::pipelineParams(daemon::configuration(options), true), rig,
                           profile, profile.width, profile.height);
    devices::FramePool pool(2);
    const devices::RgbdFrame pair = expectedPair(pool);
    pipeline.prepare(pair);
    const oracle::SearchedPanel truth(profile, profile.width, profile.height,
                                      gpu::ViewPositions::Continuous, 1.0 / 3);
    const oracle::Differences found =
        oracle::compare(image, searchInput(rig, pipeline, colorPicture(pair.color)), truth, 3);
    std::printf("%lld ms; panel against double precision: %.2f dB, max %.0f, more than 2/255: %zu "
                "of %zu\n",
                static_cast<long long>(result.wall.count()), found.psnr(), found.largest,
                found.overTwo, found.samples);
    // As of the direct method alone: rounding to 8 bits and the filter's 8-bit weights.
    EXPECT_GE(found.psnr(), 55.5);
    EXPECT_EQ(found.unexplained, 0U);
}

TEST_F(Kinect2Test, TheProgramRecordsBelowTheDecoder) {
    plugIn(5);
    const ScratchFolder folder;
    const std::string raw = folder / "camera.raw", show = folder / "show.mkv";
    ProgramCall call;
    call.program = AUTOSTEREO_PROGRAM;
    call.arguments = {"record",   "--input", "kinect2:",     "--frames", "3",
                      "--output", show,      "--record-raw", raw};
    const ProgramResult result = runProgram(call);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    EXPECT_NE(result.err.find("camera.raw: "), std::string::npos) << result.err;
    for (const std::string& file : {raw, show}) {
        const devices::Input input = devices::openInput(file);
        ASSERT_TRUE(input.depth && input.color) << file << ": " << input.description << '\n'
                                                << result.err;
        const devices::Frame depth = nextFrame(*input.depth), color = nextFrame(*input.color);
        ASSERT_FALSE(depth.empty() || color.empty()) << file;
        EXPECT_TRUE(expectedPictures().find(depth)) << file;
    }
    call.arguments = {"record", "--input", raw, "--output", folder / "m.mkv", "--record-raw", raw};
    EXPECT_EQ(runProgram(call).exitCode, 2) << "it would be written over";
}

/// A disk of so many MiB.
class SmallDisk {
  public:
    SmallDisk(std::string folder, int mib) : folder_(std::move(folder)) {
        std::filesystem::create_directory(folder_);
        const std::string size = "size=" + std::to_string(mib) + "m";
        mounted_ = mount("small", folder_.c_str(), "tmpfs", 0, size.c_str()) == 0;
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    ~SmallDisk() {
        if (mounted_) umount2(folder_.c_str(), MNT_DETACH);
    }
    [[nodiscard]] bool mounted() const { return mounted_; }

  private:
    std::string folder_;
    bool mounted_ = false;
};

class FullDiskTest : public Kinect2Test {
  protected:
    /// Runs the program with a disk that fills up before the first picture is shown.
    [[nodiscard]] ProgramResult run(std::vector<std::string> arguments) const {
        ProgramCall call;
        call.program = AUTOSTEREO_PROGRAM;
        call.arguments = std::move(arguments);
        for (const std::string& word :
             {std::string("--input"), std::string("kinect2:"), std::string("--record-raw"), raw})
            call.arguments.push_back(word);
        call.environment = {"DISPLAY=", "WAYLAND_DISPLAY="};
        ProgramResult result = runProgram(call);
        ended = result.err.find("cannot record to " + raw +
                                ": No space left on device: the recording ends here");
        EXPECT_NE(ended, std::string::npos) << result.err;
        return result;
    }

    ScratchFolder folder;
    std::string raw = folder / "disk/camera.raw";
    SmallDisk disk{folder / "disk", 12};
    mutable std::size_t ended = 0; ///< where the message stands
};

TEST_F(FullDiskTest, TheOtherRecordingGoesOn) {
    ASSERT_TRUE(disk.mounted());
    plugIn(5);
    const std::string show = folder / "show.mkv";
    const ProgramResult result = run({"record", "--frames", "5", "--output", show});
    EXPECT_EQ(result.exitCode, 1) << "not all that was asked for was recorded: " << result.err;
    for (const std::string& file : {raw, show}) {
        const devices::Input input = devices::openInput(file);
        const devices::Frame depth = nextFrame(*input.depth);
        ASSERT_FALSE(depth.empty()) << file;
        EXPECT_TRUE(expectedPictures().find(depth)) << file;
    }
}

// The guest takes a minute for a picture beside a camera that never waits.
TEST_F(FullDiskTest, ThePictureGoesOn) {
    if (!fullCampaign()) GTEST_SKIP() << "only in full campaigns (tests/run --full)";
    ASSERT_TRUE(disk.mounted());
    plugIn(5);
    const std::string report = folder / "r.json";
    const ProgramResult result = run({"run", "--config", folder.write("c.toml", kConfig),
                                      "--display", folder.write("small.toml", kDisplay), "--output",
                                      "offscreen", "--frames", "1", "--report", report});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_NE(result.err.find("panel: live", ended), std::string::npos)
        << "the first picture comes after that: " << result.err;
    std::ifstream in(report);
    const nlohmann::json accounts = nlohmann::json::parse(in);
    EXPECT_EQ(accounts.at("frames_presented").get<int>(), 1);
}

} // namespace
} // namespace autostereo::test
