// Scenes of triangles through the whole program: every kind of picture, runs, and what is refused.

#include "tests/replay/pictures.hpp"
#include "tests/replay/program.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>

namespace autostereo::test {
namespace {

/// A square in four quarters, seen from the front: red top left, green top right, blue bottom left,
/// white bottom right; a yellow stick stands out of its middle.
constexpr const char* kQuarters = R"(mtllib quarters.mtl
v -1 -1 0
v 0 -1 0
v 1 -1 0
v -1 0 0
v 0 0 0
v 1 0 0
v -1 1 0
v 0 1 0
v 1 1 0
v -0.15 0.1 0.9
v 0.15 0.1 0.9
v 0 -0.2 0.9
usemtl red
f 4 5 8 7
usemtl green
f 5 6 9 8
usemtl blue
f 1 2 5 4
usemtl white
f 2 3 6 5
usemtl yellow
f 10 11 12
)";
constexpr const char* kMaterials = "newmtl red\nKd 1 0 0\nnewmtl green\nKd 0 1 0\nnewmtl blue\n"
                                   "Kd 0 0 1\nnewmtl white\nKd 1 1 1\nnewmtl yellow\nKd 1 1 0\n";
constexpr const char* kPlain = "[scene]\nshading = \"none\"\ntilt_deg = 0\nturn_s = 0\n";

std::string colorAt(const ColorPicture& picture, double x, double y) {
    const std::uint8_t* rgb =
        picture.at(static_cast<int>(x * picture.width), static_cast<int>(y * picture.height));
    std::string text;
    for (int c = 0; c < 3; ++c)
        text += rgb[c] > 250 ? '1' : rgb[c] < 5 ? '0' : '?';
    return text;
}

class SceneContent : public testing::Test {
  protected:
    void SetUp() override {
        folder.file("quarters.mtl", kMaterials);
        scene = folder.file("quarters.obj", kQuarters);
    }
    std::vector<std::string> command(const std::string& name, const std::string& config) {
        return {name,
                "--input",
                scene,
                "--display",
                smallDisplay(folder),
                "--config",
                folder.file("config.toml", config)};
    }
    [[nodiscard]] std::string output(const std::string& as) const {
        return folder / (as == "views" ? "views" : "out.png");
    }
    ColorPicture render(const std::string& as, const std::string& config = kPlain,
                        const std::vector<std::string>& more = {}) {
        auto arguments = command("render", config);
        arguments.insert(arguments.end(), {"--as", as, "--output", output(as)});
        arguments.insert(arguments.end(), more.begin(), more.end());
        EXPECT_TRUE(succeeded(runProgram(calling(arguments))));
        return readColor(as == "views" ? output(as) + "/view_00.png" : output(as));
    }
    /// Runs off-screen; the panel, and the accounts beside it.
    ColorPicture run(const std::string& config, const std::vector<std::string>& more) {
        auto arguments = command("run", config);
        arguments.insert(arguments.end(),
                         {"--output", "offscreen", "--snapshot", folder / "panel.png", "--report",
                          folder / "report.json"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        EXPECT_TRUE(succeeded(runProgram(calling(arguments))));
        report = readReport(folder / "report.json");
        const RunReport::Accounts& all = report.accounts; // moments of the scene: no streams
        EXPECT_EQ(all.framesIn, all.presented + all.skipped + all.dropped);
        return readColor(folder / "panel.png");
    }
    /// What the last run reports.
    [[nodiscard]] std::string methodInUse() const {
        std::ifstream file(folder / "report.json");
        return nlohmann::json::parse(file).at("method").get<std::string>();
    }
    TempFolder folder;
    std::string scene;
    RunReport report;
};

/// The square spans about 80 % of the panel's height, somewhat behind the panel.
void expectQuarters(const ColorPicture& picture) {
    const double aspect = static_cast<double>(kSmallHeight) / kSmallWidth;
    const double near = 0.2, far = 0.38; // of the height, from the middle
    EXPECT_EQ(colorAt(picture, 0.5 - near * aspect, 0.5 - near), "100");
    EXPECT_EQ(colorAt(picture, 0.5 + near * aspect, 0.5 - near), "010");
    EXPECT_EQ(colorAt(picture, 0.5 - near * aspect, 0.5 + near), "001");
    EXPECT_EQ(colorAt(picture, 0.5 + near * aspect, 0.5 + near), "111");
    EXPECT_EQ(colorAt(picture, 0.5 - far * aspect, 0.5 - far), "100");
    EXPECT_EQ(colorAt(picture, 0.5 - 0.42 * aspect, 0.5), "000");
    EXPECT_EQ(colorAt(picture, 0.5, 0.08), "000");
}

TEST_F(SceneContent, EveryKindOfPictureIsRightSideUp) {
    expectQuarters(render("view"));
    expectQuarters(render("panel"));
    const ColorPicture quilt = render("quilt");
    EXPECT_EQ(quilt.width, 4 * kSmallTileWidth);
    EXPECT_EQ(quilt.height, 2 * kSmallTileHeight);
    const ColorPicture view = render("views");
    EXPECT_EQ(view.width, kSmallTileWidth);
    expectQuarters(view);
    render("sbs");
    const ColorPicture pair = render("2d-plus-depth");
    EXPECT_EQ(pair.width, kSmallWidth);
}

/// What stands in front of the panel moves against the eye, and its depth is bright.
TEST_F(SceneContent, TheStickStandsInFrontOfThePanel) {
    render("views");
    const auto stick = [&](const std::string& file) {
        const ColorPicture view = readColor(file);
        double sum = 0;
        int count = 0;
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) {
                const std::uint8_t* rgb = view.at(x, y);
                if (rgb[0] > 250 && rgb[1] > 250 && rgb[2] < 5) {
                    sum += x;
                    ++count;
                }
            }
        EXPECT_GT(count, 4) << file;
        return sum / count;
    };
    const double left = stick(folder / "views/view_00.png");
    const double right = stick(folder / "views/view_07.png");
    // The budget, 0.02 panel widths, is for the corners that reach farthest when the scene is
    // turned, 1.097 from its axis; the stick stands at 0.45. Heights: D d / (Bx + d), Bx = 0.428, D
    // = 1 m.
    const double height = 0.45 / 1.097 * 0.02 / (0.428 + 0.02);
    const double disparity = 0.428 * height / (1 - height);
    EXPECT_NEAR(left - right, 2 * 7 / 8.0 * disparity * kSmallTileWidth, 0.5) << "half a pixel";
    render("views", std::string(kPlain) + "[picture]\nmode = \"2d\"\n");
    EXPECT_NEAR(stick(folder / "views/view_00.png"), stick(folder / "views/view_07.png"), 0.5);
}

/// To rounding, which shows at edges only.
TEST_F(SceneContent, EveryMethodDrawsIt) {
    const ColorPicture instanced = render("quilt");
    for (const char* method : {"multipass", "geometry", "mrt"}) {
        const ColorPicture other = render("quilt", kPlain, {"--method", method});
        ASSERT_EQ(other.rgb.size(), instanced.rgb.size());
        std::size_t different = 0;
        for (std::size_t i = 0; i < other.rgb.size(); ++i)
            if (other.rgb[i] != instanced.rgb[i]) ++different;
        EXPECT_LE(different, other.rgb.size() / 1000) << method;
    }
}

/// By way of a few viewpoints the same picture, away from edges.
TEST_F(SceneContent, FewViewpointsShowItAll) {
    for (const char* method : {"hybrid", "direct"}) {
        expectQuarters(render("panel", kPlain, {"--method", method}));
        expectQuarters(run(std::string(kPlain) + "[synthesis]\nmethod = \"" + method + "\"\n",
                           {"--frames", "1", "--speed", "max"}));
        EXPECT_EQ(methodInUse(), method);
    }
    const ColorPicture instanced = render("quilt"),
                       other = render("quilt", kPlain, {"--method", "hybrid"});
    ASSERT_EQ(other.rgb.size(), instanced.rgb.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < other.rgb.size(); ++i)
        if (other.rgb[i] != instanced.rgb[i]) ++different;
    EXPECT_LE(different, other.rgb.size() / 50);
    run("[scene]\nshading = \"per-vertex\"\n[synthesis]\nmethod = \"hybrid\"\n", {"--frames", "1"});
    EXPECT_EQ(methodInUse(), "instanced") << "light at vertices cannot be put off";
}

/// A run's picture number five is the render's.
TEST_F(SceneContent, ARunShowsWhatRenderShows) {
    const std::string turning = "[scene]\nturn_s = 1\n";
    const ColorPicture shown = run(turning, {"--speed", "max", "--frames", "5"});
    EXPECT_EQ(report.accounts.presented, 5U);
    EXPECT_TRUE(shown == render("panel", turning, {"--frame", "4"}));
    EXPECT_FALSE(shown == render("panel", turning, {"--frame", "0"})) << "it turns";
}

TEST_F(SceneContent, WhatDoesNotMoveIsNotDrawnAgain) {
    const ColorPicture shown = run(kPlain, {"--speed", "max", "--frames", "5"});
    EXPECT_EQ(report.accounts.presented, 1U);
    EXPECT_EQ(report.accounts.skipped, 4U);
    expectQuarters(shown);
    expectQuarters(run(kPlain, {"--frames", "3"}));
}

TEST_F(SceneContent, WhatNeedsCamerasIsRefusedPlainly) {
    const auto refused = [&](std::vector<std::string> arguments, int code) {
        EXPECT_TRUE(failedPlainly(runProgram(calling(arguments)), code)) << arguments[0];
    };
    const auto with = [&](const std::string& name, const std::vector<std::string>& more) {
        auto arguments = command(name, kPlain);
        arguments.insert(arguments.end(), more.begin(), more.end());
        return arguments;
    };
    const std::string out = folder / "o.png";
    refused(with("render", {"--as", "depth", "--output", out}), 2);
    refused(with("render", {"--as", "view", "--camera-offset", "0,0,0", "--output", out}), 2);
    refused(with("render", {"--as", "panel", "--reference", "--output", out}), 2);
    refused(with("render", {"--as", "quilt", "--method", "direct", "--output", out}), 2);
    refused(with("run", {"--output", "offscreen", "--record", folder / "r.mkv"}), 2);
    refused({"record", "--input", scene, "--output", folder / "r.mkv"}, 2);
    scene = folder / "gone.glb";
    refused(with("run", {"--output", "offscreen"}), 3);
    refused(with("render", {"--as", "panel", "--output", out}), 3);
    scene = folder / "quarters.obj";
    for (const char* method : {"hybrid", "direct"}) {
        auto arguments = command("render", "[scene]\nshading = \"per-vertex\"\n");
        arguments.insert(arguments.end(), {"--as", "panel", "--method", method, "--output", out});
        refused(arguments, 2);
    }
    scene = folder.file("broken.ply", "ply\nformat ascii 1.0\nelement vertex 9999999999\n"
                                      "property float x\nend_header\n");
    refused(with("run", {"--output", "offscreen"}), 1);
}

TEST_F(SceneContent, CheckSaysWhatAFileHolds) {
    EXPECT_TRUE(succeeded(runProgram(calling({"check", scene}))));
    const std::string holes = folder.file("holes.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\n"
                                                       "f 1 2 3\nf 1 2 4\n");
    const ProgramResult result = runProgram(calling({"check", holes}));
    EXPECT_EQ(result.exitCode, 2);
    EXPECT_NE(result.err.find("1 triangles without finite corners left out"), std::string::npos)
        << result.err;
}

} // namespace
} // namespace autostereo::test
