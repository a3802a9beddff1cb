#include "tests/replay/pictures.hpp"
#include "tests/replay/program.hpp"
#include "tests/support/data.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <random>

namespace autostereo::test {
namespace {

constexpr std::chrono::seconds kNoHang{10 * kSlower};

class MalformedInput : public testing::Test {
  protected:
    [[nodiscard]] ProgramResult play(const std::string& input,
                                     std::vector<std::string> more = {}) const {
        std::vector<std::string> arguments{"run",
                                           "--input",
                                           input,
                                           "--display",
                                           smallDisplay(folder),
                                           "--output",
                                           "offscreen",
                                           "--speed",
                                           "max",
                                           "--frames",
                                           "2",
                                           "--report",
                                           folder / "report.json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        auto call = calling(arguments);
        call.limit = kNoHang;
        return runProgram(call);
    }
    /// A plain failure, or frames that were shown or counted as damaged.
    void expectDealtWith(const ProgramResult& result) const {
        if (result.exitCode != 0) {
            EXPECT_TRUE(failedPlainly(result));
            return;
        }
        EXPECT_TRUE(succeeded(result));
        const RunReport::Accounts all = readReport(folder / "report.json").accounts;
        EXPECT_GT(all.presented + all.depth.damaged + all.color.damaged, 0U) << result.err;
    }
    TempFolder folder;
};

/// The one real recording, damaged at random places (the same ones every time).
class DamagedRecording : public MalformedInput {
  protected:
    void SetUp() override {
        AUTOSTEREO_NEED_DATA("k4a-mug/recording.mkv");
        std::ifstream bytes(dataDir() / "k4a-mug/recording.mkv", std::ios::binary);
        whole.assign(std::istreambuf_iterator<char>(bytes), {});
    }
    /// Half of the places in the first part: there the structure is, the rest is pixels.
    [[nodiscard]] std::size_t place() {
        constexpr std::size_t kHead = 16'384;
        const std::size_t end = random() % 2 == 0 ? kHead : whole.size();
        return std::uniform_int_distribution<std::size_t>(0, end - 1)(random);
    }
    static int cases() { return fullCampaign() ? 100 : 6; }

    std::string whole;
    std::mt19937 random{20'240'601};
};

TEST_F(DamagedRecording, CutOff) {
    for (int i = 0; i < cases(); ++i) {
        const std::size_t length = place();
        SCOPED_TRACE("the first " + std::to_string(length) + " bytes");
        expectDealtWith(play(folder.file("cut.mkv", whole.substr(0, length))));
    }
}

TEST_F(DamagedRecording, OneByteFlipped) {
    for (int i = 0; i < cases(); ++i) {
        const std::size_t at = place();
        std::string bytes = whole;
        bytes[at] = static_cast<char>(bytes[at] ^ static_cast<char>(1 + random() % 255));
        SCOPED_TRACE("byte " + std::to_string(at) + " is " +
                     std::to_string(static_cast<unsigned char>(bytes[at])));
        expectDealtWith(play(folder.file("flipped.mkv", bytes)));
    }
}

TEST_F(MalformedInput, FilesThatAreNotThere) {
    EXPECT_TRUE(failedPlainly(play(folder / "none.mkv"), 3));
    EXPECT_TRUE(failedPlainly(play("seq:" + folder / "none"), 3));
    EXPECT_TRUE(failedPlainly(play("tum:" + folder / "none"), 3));
    EXPECT_TRUE(failedPlainly(play("rgbd:" + folder / "none.png" + ",,"), 3));
    std::filesystem::create_directory(folder / "empty");
    EXPECT_TRUE(failedPlainly(play("seq:" + folder / "empty"), 3));
    EXPECT_TRUE(failedPlainly(play("tum:" + folder / "empty"), 3));
}

TEST_F(MalformedInput, FilesThatAreSomethingElse) {
    EXPECT_TRUE(failedPlainly(play(folder.file("empty.mkv", "")), 1));
    EXPECT_TRUE(failedPlainly(play(folder.file("text.mkv", "not a recording\n")), 1));
    EXPECT_TRUE(failedPlainly(play(folder.file("notes.txt", "not a recording\n"))));
    expectDealtWith(play("rgbd:" + folder.file("color.png", "not a picture") + ",,"));
    EXPECT_TRUE(failedPlainly(play("ftp:somewhere")));
    EXPECT_TRUE(failedPlainly(play("v4l2:/dev/video0")));
    EXPECT_TRUE(failedPlainly(play("sim:nowhere")));
    EXPECT_TRUE(failedPlainly(play("sim:room?depth=0x0")));
}

TEST_F(MalformedInput, PicturesOfAWrongSizeAreCounted) {
    const std::string camera = cameraFile(folder, 64, 36);
    const std::string color = writeColor(folder / "color.png", 64, 36, [](int x, int y) {
        return Rgb{static_cast<std::uint8_t>(3 * x), static_cast<std::uint8_t>(5 * y), 90};
    });
    const std::string depth =
        writeDepth(folder / "depth.png", 48, 30, [](int, int) { return 1000; });
    const ProgramResult result = play("rgbd:" + color + "," + depth + "," + camera);
    EXPECT_NE(result.err.find("48x30"), std::string::npos) << result.err;
    expectDealtWith(result);
    if (result.exitCode == 0) {
        EXPECT_EQ(readReport(folder / "report.json").accounts.depth.damaged, 1U);
    }
}

struct BadCameras {
    const char* name;
    const char* depth; ///< the depth block of a camera.json
};

class MalformedCameras : public MalformedInput, public testing::WithParamInterface<BadCameras> {};

TEST_P(MalformedCameras, AreRefusedInOneLine) {
    const std::string color = writeColor(folder / "color.png", 64, 36, [](int, int) {
        return Rgb{1, 2, 3};
    });
    const std::string depth =
        writeDepth(folder / "depth.png", 64, 36, [](int, int) { return 1000; });
    const std::string camera =
        folder.file("camera.json", std::string("{\"depth\": ") + GetParam().depth + "}");
    const ProgramResult asInput = play("rgbd:" + color + "," + depth + "," + camera);
    EXPECT_TRUE(failedPlainly(asInput));
    EXPECT_NE(asInput.err.find("camera.json"), std::string::npos) << asInput.err;
    EXPECT_TRUE(failedPlainly(play(kSmallRoom, {"--rig", camera}), 2));
}

INSTANTIATE_TEST_SUITE_P(
    CameraJson, MalformedCameras,
    testing::Values(
        BadCameras{"NaN", R"({"width":64,"height":36,"fx":NaN,"fy":64,"cx":31,"cy":17})"},
        BadCameras{"Huge", R"({"width":64,"height":36,"fx":1e999,"fy":64,"cx":31,"cy":17})"},
        BadCameras{"ZeroFocal", R"({"width":64,"height":36,"fx":0,"fy":64,"cx":31,"cy":17})"},
        BadCameras{"MissingKey", R"({"width":64,"height":36,"fx":64,"fy":64,"cx":31})"},
        BadCameras{"Text", R"({"width":64,"height":36,"fx":"64","fy":64,"cx":31,"cy":17})"},
        BadCameras{"NoSize", R"({"width":-64,"height":0,"fx":64,"fy":64,"cx":31,"cy":17})"},
        BadCameras{"Truncated", R"({"width":64,)"}),
    [](const auto& tested) { return std::string(tested.param.name); });

TEST_F(MalformedInput, WrongCommandLines) {
    const auto fails = [](std::vector<std::string> arguments) {
        return failedPlainly(runProgram(calling(std::move(arguments))), 2);
    };
    EXPECT_TRUE(fails({}));
    EXPECT_TRUE(fails({"dance"}));
    EXPECT_TRUE(fails({"run", "--loud"}));
    EXPECT_TRUE(fails({"run", "--frames", "0"}));
    EXPECT_TRUE(fails({"run", "--frames", "many"}));
    EXPECT_TRUE(fails({"run", "--display", "cathode-ray-tube"}));
    EXPECT_TRUE(fails({"run", "--input", "sim:room", "--record-raw", folder / "a"}))
        << "there is nothing below its decoder";
    EXPECT_TRUE(fails({"render", "--as", "panel"})) << "--output is missing";
    EXPECT_TRUE(fails({"render", "--as", "hologram", "--output", folder / "p.png"}));
    EXPECT_TRUE(fails({"render", "--as", "view", "--eye", "0,0", "--output", folder / "p.png"}));
    EXPECT_TRUE(fails({"run", "--input", "quilt:q.png"})) << "known, but not in this version";
    EXPECT_TRUE(fails({"run", "--input", "sim:moon"}));
    EXPECT_TRUE(fails({"run", "--input", "sim:room?fog=1"}));
    EXPECT_TRUE(fails({"viewmap"})) << "--display is missing";
}

TEST_F(MalformedInput, WrongConfigurationsSayWhere) {
    const std::string config = folder.file("bad.toml", "[input]\nuri = 5\n");
    const ProgramResult result = play(kSmallRoom, {"--config", config});
    EXPECT_TRUE(failedPlainly(result, 2));
    EXPECT_NE(result.err.find("bad.toml:2:7: "), std::string::npos) << result.err;

    const std::string display = folder.file("display.toml", "type = \"van_berkel\"\n]\n");
    const ProgramResult refused =
        runProgram(calling({"render", "--input", kSmallRoom, "--display", display, "--as", "panel",
                            "--output", folder / "panel.png"}));
    EXPECT_TRUE(failedPlainly(refused, 2));
    EXPECT_NE(refused.err.find("display.toml:2:1: "), std::string::npos) << refused.err;
    EXPECT_TRUE(failedPlainly(play(kSmallRoom, {"--config", folder / "none.toml"})));
}

TEST_F(MalformedInput, WrongDisplaysSayWhere) {
    const auto said = [this](const std::string& display) {
        const ProgramResult result =
            runProgram(calling({"viewmap", "--display", display, "--output", folder / "map.npy"}));
        EXPECT_TRUE(failedPlainly(result, 2));
        return result.err;
    };
    std::filesystem::create_directory(folder / "folder.toml");
    const std::string json = folder.file("cut.json", "{\"pitch\": 50");
    const std::string base = folder.file("base.toml", "base = \"preview\"\ntype = \"lut\"\n");
    EXPECT_EQ(said(folder / "folder.toml"),
              "autostereo: " + (folder / "folder.toml") + ": cannot be read: Is a directory\n");
    EXPECT_EQ(said(folder.file("long.toml", std::string(2 << 20, ' '))),
              "autostereo: " + (folder / "long.toml") +
                  ": cannot be read: it is longer than 1 MiB\n");
    EXPECT_EQ(said(json), "autostereo: " + json +
                              ":1:13: is no JSON: syntax error while parsing object - unexpected "
                              "end of input; expected '}'\n");
    EXPECT_EQ(said(base), "autostereo: " + base +
                              ":1:8: base: \"preview\" is of type anaglyph (allowed displays of "
                              "the file's own type)\n");
    EXPECT_EQ(said("preveiw"), "autostereo: display: \"preveiw\" is no profile and no file *.toml "
                               "(did you mean preview?)\n");
}

TEST_F(MalformedInput, OutputsThatCannotBeWritten) {
    EXPECT_TRUE(failedPlainly(play(kSmallRoom, {"--snapshot", folder / "none/panel.png"}), 1));
    EXPECT_TRUE(failedPlainly(
        runProgram(calling({"render", "--input", kSmallRoom, "--display", smallDisplay(folder),
                            "--as", "panel", "--output", folder / "none/panel.png"})),
        1));
}

} // namespace
} // namespace autostereo::test
