#include "devices/input.hpp"
#include "devices/uri.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/replay/playing.hpp"

#include <gtest/gtest.h>

#include <string>

namespace autostereo {
namespace {

using devices::DeviceError;
using devices::openInput;
using devices::parseUri;

TEST(Uri, partsAndPlainNames) {
    const auto uri = parseUri("seq:/a/b c?fps=12.5&x=");
    EXPECT_EQ(uri.scheme, "seq");
    EXPECT_EQ(uri.path, "/a/b c");
    EXPECT_EQ(uri.number("fps", 30, 1, 100), 12.5);
    EXPECT_EQ(uri.number("absent", 30, 1, 100), 30);
    EXPECT_EQ(uri.value("x"), "");
    EXPECT_EQ(parseUri("./a:b?c.mkv").path, "./a:b?c.mkv");
    EXPECT_EQ(parseUri("recording.mkv").scheme, "");
    EXPECT_EQ(parseUri("").path, "");
}

std::string messageOf(const std::string& uri) try {
    static_cast<void>(openInput(uri));
    return "";
} catch (const DeviceError& error) {
    return error.what();
}

TEST(Uri, mistakesAreNamed) {
    const test::ScratchFolder folder;
    const std::string seq = "seq:" + folder.path().string();
    EXPECT_EQ(messageOf(seq + "?speed=3"), seq + "?speed=3: unknown key speed (allowed fps)");
    EXPECT_EQ(messageOf(seq + "?fps=0"), seq + "?fps=0: fps = '0' (allowed 1 to 1000)");
    EXPECT_EQ(messageOf(seq + "?fps=nan"), seq + "?fps=nan: fps = 'nan' (allowed 1 to 1000)");
    EXPECT_EQ(messageOf(seq + "?fps=9x"), seq + "?fps=9x: fps = '9x' (allowed 1 to 1000)");
    EXPECT_EQ(messageOf(seq + "?fps"), seq + "?fps: 'fps' is no key=value");
    EXPECT_EQ(messageOf(seq + "?fps=1&fps=2"), seq + "?fps=1&fps=2: fps is given twice");
    EXPECT_EQ(messageOf("rgbd:?a=b"), "rgbd:?a=b: unknown key a (allowed none)");
}

TEST(OpenInput, whatIsNotThereIsNotFound) {
    for (const char* uri : {"/no/such/file.mkv", "seq:/no/such/folder", "tum:/no/such/folder",
                            "v4l2:/dev/no-such-camera", "v4l2:serial=no such", "kinect2:no-such"}) {
        try {
            static_cast<void>(openInput(uri));
            FAIL() << uri;
        } catch (const DeviceError& error) {
            EXPECT_TRUE(error.notFound()) << error.what();
        }
    }
}

TEST(OpenInput, laterInputsSaySo) {
    for (const char* uri : {"quilt:q.png", "sbs:a.png", "idle:"})
        EXPECT_NE(messageOf(uri).find("not in this version"), std::string::npos) << uri;
    for (const char* uri : {"scene.glb", "scene.gltf", "scene.OBJ", "scene.ply"})
        EXPECT_NE(messageOf(uri).find("is a scene, no camera"), std::string::npos) << uri;
    EXPECT_NE(messageOf("ftp:x").find("unknown scheme ftp:"), std::string::npos);
}

TEST(OpenInput, otherFilesAreRefused) {
    const test::ScratchFolder folder;
    EXPECT_NE(messageOf(folder.write("a.txt", "x")).find("unknown kind of file"),
              std::string::npos);
    for (const std::string& text : {std::string(), std::string("x"), std::string(5000, '\0')})
        EXPECT_NE(messageOf(folder.write("a.mkv", text)).find("not a Matroska file"),
                  std::string::npos);
    std::filesystem::create_directory(folder / "b.mkv");
    EXPECT_NE(messageOf(folder / "b.mkv").find("not a file"), std::string::npos);
}

TEST(OpenInput, simulationIsReached) {
    const auto input = openInput("sim:room?frames=2&depth=64x48&color=64x48");
    EXPECT_EQ(test::countFrames(*input.depth), 2);
}

} // namespace
} // namespace autostereo
