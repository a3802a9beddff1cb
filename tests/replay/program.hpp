#pragma once

#include "tests/support/run_program.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace autostereo::test {

/// Sanitizers make the program several times slower; bounds on time are multiplied by this.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr int kSlower = 5;
#else
constexpr int kSlower = 1;
#endif

/// A small scene, 10 ms to make and some to draw; append "&noise=off" and so on.
constexpr const char* kSmallRoom = "sim:room?depth=176x144&color=320x180";
constexpr const char* kSmallPerson = "sim:person?depth=176x144&color=320x180";

/// A new folder, removed with what is in it.
class TempFolder {
  public:
    TempFolder();
    ~TempFolder();
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    /// A name in the folder.
    [[nodiscard]] std::string operator/(const std::string& name) const { return path_ / name; }
    /// Writes a file of that name; its path.
    std::string file(const std::string& name, const std::string& text) const;

  private:
    std::filesystem::path path_;
};

/// A display file in the folder: eight slanted views, 320x180 pixels, 4x2 tiles of 160x90.
constexpr int kSmallWidth = 320, kSmallHeight = 180, kSmallViews = 8;
constexpr int kSmallTileWidth = 160, kSmallTileHeight = 90;
[[nodiscard]] std::string smallDisplay(const TempFolder& folder);

/// A camera.json for registered pictures of one size: focal length = width, centre in the middle.
[[nodiscard]] std::string cameraFile(const TempFolder& folder, int width, int height);

/// A rig file: two cameras of 640x480 and 500 px focal length in one place.
[[nodiscard]] std::string twoCameras(const TempFolder& folder);

/// The program with these arguments, without a display server, 60 s at most.
[[nodiscard]] ProgramCall calling(std::vector<std::string> arguments);

/// Success: exit code 0; else what it said.
[[nodiscard]] testing::AssertionResult succeeded(const ProgramResult& result);

/// A failure as people should see it: exit code 1 to 3 (or the one given) and one line on stderr,
/// beside those of the log, that starts with the program's name.
[[nodiscard]] testing::AssertionResult failedPlainly(const ProgramResult& result,
                                                     std::optional<int> exitCode = {});

/// What `--report` says.
struct RunReport {
    struct Stream {
        std::uint64_t in, paired, unpaired, damaged;
        [[nodiscard]] bool operator==(const Stream&) const = default;
    };
    /// What must be the same in two runs of the same frames.
    struct Accounts {
        Stream depth, color;
        std::uint64_t framesIn, presented, skipped, dropped, withoutDepth;
        [[nodiscard]] bool operator==(const Accounts&) const = default;
    };
    Accounts accounts;
    std::optional<double> latencyP50Ms, latencyP99Ms;
    double seconds;
    std::string renderer;
};

/// Throws where the file is no such report.
[[nodiscard]] RunReport readReport(const std::string& file);

/// in = paired + unpaired for both streams; frames in = presented + skipped + dropped.
[[nodiscard]] testing::AssertionResult balanced(const RunReport& report);

} // namespace autostereo::test
