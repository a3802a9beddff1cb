#pragma once

#include "tests/replay/pictures.hpp"
#include "tests/replay/program.hpp"

#include <gtest/gtest.h>

#include <string>

namespace autostereo::test {

/// A quarter of the Personal Varrier's panel each way, with the same barrier.
inline constexpr const char* kBarrier = R"(type = "line_screen"
base = "personal-varrier-30"
model = "Small tracked barrier"
[panel]
width = 640
height = 400
width_mm = 160.34
[quilt]
columns = 2
rows = 1
tile_width = 320
tile_height = 400
)";
/// A small tracked barrier and what eyes see of it, through the program alone.
class TrackedPanel {
  public:
    TrackedPanel() : display_(folder_.file("barrier.toml", kBarrier)) {}

    [[nodiscard]] const TempFolder& folder() const { return folder_; }
    [[nodiscard]] const std::string& display() const { return display_; }
    /// Runs it; the last panel is what the others look at.
    void run(const std::string& input, const std::string& config,
             const std::vector<std::string>& more) {
        input_ = input;
        std::vector<std::string> words{"run",
                                       "--config",
                                       folder_.file("viewer.toml", config),
                                       "--input",
                                       input_,
                                       "--display",
                                       display_,
                                       "--output",
                                       "offscreen",
                                       "--snapshot",
                                       folder_ / "panel.png"};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_TRUE(succeeded(runProgram(calling(words))));
    }
    /// What an eye sees of it.
    [[nodiscard]] ColorPicture seen(const std::string& eye) const {
        EXPECT_TRUE(succeeded(
            runProgram(calling({"look", "--panel", folder_ / "panel.png", "--display", display_,
                                "--eye", eye, "--output", folder_ / "seen.png"}))));
        return readColor(folder_ / "seen.png");
    }
    /// What that eye should see. Where eyes are followed, three times the depth budget of 0.05 is
    /// kept beyond either edge of the panel: the scene is 1.3 / 1.1 larger.
    [[nodiscard]] ColorPicture view(const std::string& eye, double zoom = 1.3 / 1.1) const {
        const std::string config =
            folder_.file("zoom.toml", "framing.zoom = " + std::to_string(zoom) + "\n");
        EXPECT_TRUE(succeeded(runProgram(
            calling({"render", "--config", config, "--input", input_, "--display", display_, "--as",
                     "view", "--eye", eye, "--output", folder_ / "view.png"}))));
        return readColor(folder_ / "view.png");
    }

  private:
    TempFolder folder_;
    std::string display_, input_;
};

} // namespace autostereo::test
