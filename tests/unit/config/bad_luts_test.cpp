#include "devices/replay/image_files.hpp"
#include "devices/replay/npy_file.hpp"
#include "tests/unit/config/bad_texts.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace autostereo::config {
namespace {

constexpr int kWidth = 32, kHeight = 16;

std::string display(const std::string& file, const std::string& holds) {
    return "type = \"lut\"\nmodel = \"bad\"\n"
           "panel = { width = 32, height = 16, width_mm = 500 }\n"
           "viewing = { distance_m = 0.7, cone_deg = 30, views = 8, view_order = "
           "\"left_to_right\", fan = \"centres\" }\n"
           "quilt = { columns = 4, rows = 2, tile_width = 640, tile_height = 360 }\n"
           "depth_budget = { far = -0.02, near = 0.02 }\n"
           "lens = { file = \"" +
           file + "\", holds = \"" + holds +
           "\" }\n"
           "provenance = { width_mm = \"measured\", distance_m = \"measured\", cone_deg = "
           "\"measured\", file = \"per-unit\" }\n";
}

class BadLuts : public test::TempFolder {
  protected:
    static std::string message(const std::string& file, const std::string& holds) {
        return bad::messageOf(display(file, holds));
    }
    template<class Element>
    static void writeArray(const std::string& type, std::vector<std::size_t> shape,
                           const std::vector<Element>& elements) {
        devices::writeNpy("v.npy", {type, std::move(shape)}, std::as_bytes(std::span(elements)));
    }
    template<class Element>
    static std::vector<Element> filled(Element value = 0) {
        return std::vector<Element>(std::size_t{3} * kWidth * kHeight, value);
    }
    static std::string bytesOf(const std::string& file) {
        const auto bytes = devices::readFile(file, 1 << 20);
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }
    static void writePicture(int width, int height, devices::ImageFormat format) {
        const devices::ImageHeader header{format, width, height};
        const std::vector<std::byte> pixels(header.bytes(), std::byte{3});
        devices::writePng("v.png", {header, pixels});
    }
};

const std::vector<std::size_t> kShape{kHeight, kWidth, 3};

TEST_F(BadLuts, goodOnesLoad) {
    writeArray("|u1", kShape, filled<std::uint8_t>(7));
    EXPECT_EQ(message("v.npy", "views"), "no error");
    writeArray("<f8", kShape, filled<double>(-1e300));
    EXPECT_EQ(message("v.npy", "phases"), "no error");
    writePicture(kWidth, kHeight, devices::ImageFormat::Rgb8);
    EXPECT_EQ(message("v.png", "views"), "no error");
}

TEST_F(BadLuts, filesThatAreNone) {
    EXPECT_EQ(message("none.npy", "views"),
              "x.toml:7:17: lens.file: cannot read none.npy: No such file or directory");
    EXPECT_EQ(message("", "views"), "x.toml:7:17: lens.file: is empty (allowed *.npy, *.png)");
    std::filesystem::create_directory("folder.npy");
    EXPECT_EQ(message("folder.npy", "views"),
              "x.toml:7:17: lens.file: cannot read folder.npy: Is a directory");
    write("v.txt", "0 1 2");
    EXPECT_EQ(message("v.txt", "views"), "x.toml:7:17: lens.file: v.txt: is no .npy and no .png");
    write("v.npy", "");
    EXPECT_EQ(message("v.npy", "views"), "x.toml:7:17: lens.file: v.npy: not a NumPy array that "
                                         "can be read: it does not start like one");
    write("v.npy", "0 1 2 3 4 5 6 7 8");
    EXPECT_EQ(message("v.npy", "views"), "x.toml:7:17: lens.file: v.npy: not a NumPy array that "
                                         "can be read: it does not start like one");
    write("v.png", "");
    EXPECT_EQ(message("v.png", "views"), "x.toml:7:17: lens.file: v.png: is no PNG and no JPEG");
    write("v.png", "no picture");
    EXPECT_EQ(message("v.png", "views"), "x.toml:7:17: lens.file: v.png: is no PNG and no JPEG");
    EXPECT_EQ(message("v.png", "angles"),
              "x.toml:7:34: lens.holds: \"angles\" is unknown (allowed views, phases)");
}

TEST_F(BadLuts, arraysOfAnotherKind) {
    writeArray("|u1", {kHeight, kWidth}, std::vector<std::uint8_t>(kHeight * kWidth));
    EXPECT_EQ(message("v.npy", "views"),
              "x.toml:7:17: lens.file: v.npy: is 16 x 32 (allowed 16 x 32 x 3, as the panel)");
    writeArray("|u1", {kWidth, kHeight, 3}, filled<std::uint8_t>());
    EXPECT_EQ(message("v.npy", "views"),
              "x.toml:7:17: lens.file: v.npy: is 32 x 16 x 3 (allowed 16 x 32 x 3, as the panel)");
    writeArray("<f4", kShape, filled<float>());
    EXPECT_EQ(message("v.npy", "views"),
              "x.toml:7:17: lens.file: v.npy: holds <f4 (allowed |u1, <u2, <u4 for views)");
    writeArray("|u1", kShape, filled<std::uint8_t>());
    EXPECT_EQ(message("v.npy", "phases"),
              "x.toml:7:17: lens.file: v.npy: holds |u1 (allowed <u4, <f4, <f8 for phases)");
    write("v.npy", test::edited(bytesOf("v.npy"), "|u1", "<i8"));
    EXPECT_EQ(message("v.npy", "views"),
              "x.toml:7:17: lens.file: v.npy: not a NumPy array that can be read: its type '<i8' "
              "(allowed |u1, <u2, <u4, <f4, <f8)");
    writeArray("|u1", kShape, filled<std::uint8_t>());
    write("v.npy", test::edited(bytesOf("v.npy"), "False", "True "));
    EXPECT_EQ(message("v.npy", "views"), "x.toml:7:17: lens.file: v.npy: not a NumPy array that "
                                         "can be read: it is in Fortran order");
    writeArray("|u1", kShape, filled<std::uint8_t>());
    const std::string whole = bytesOf("v.npy");
    write("v.npy", whole.substr(0, whole.size() - 1));
    EXPECT_EQ(message("v.npy", "views"), "x.toml:7:17: lens.file: v.npy: not a NumPy array that "
                                         "can be read: it holds 1535 bytes, its header says 1536");
    write("v.npy", whole.substr(0, 40));
    EXPECT_EQ(
        message("v.npy", "views"),
        "x.toml:7:17: lens.file: v.npy: not a NumPy array that can be read: its header is cut off");
    write("v.npy", test::edited(whole, "(16,", "(99999999999999999999,"));
    EXPECT_EQ(message("v.npy", "views"),
              "x.toml:7:17: lens.file: v.npy: not a NumPy array that can be read: it holds 1554 "
              "bytes, its header says 412316860416");
}

TEST_F(BadLuts, elementsOutOfRange) {
    auto views = filled<std::uint16_t>(7);
    views[5] = 8;
    writeArray("<u2", kShape, views);
    EXPECT_EQ(message("v.npy", "views"),
              "x.toml:7:17: lens.file: v.npy: element 5 is 8 (allowed 0 to 7)");
    auto phases = filled<float>(0.5F);
    phases[7] = std::numeric_limits<float>::quiet_NaN();
    writeArray("<f4", kShape, phases);
    EXPECT_EQ(message("v.npy", "phases"),
              "x.toml:7:17: lens.file: v.npy: element 7 is nan (allowed finite phases)");
}

TEST_F(BadLuts, picturesOfAnotherKind) {
    writePicture(kHeight, kWidth, devices::ImageFormat::Rgb8);
    EXPECT_EQ(message("v.png", "views"),
              "x.toml:7:17: lens.file: v.png: is 16x32 (allowed an 8-bit picture of 32x16)");
    writePicture(kWidth, kHeight, devices::ImageFormat::Grey16);
    EXPECT_EQ(
        message("v.png", "views"),
        "x.toml:7:17: lens.file: v.png: is 32x16, 16-bit (allowed an 8-bit picture of 32x16)");
    writePicture(kWidth, kHeight, devices::ImageFormat::Rgb8);
    EXPECT_EQ(message("v.png", "phases"),
              "x.toml:7:17: lens.file: v.png: a picture holds no phases (allowed .npy)");
    const std::string whole = bytesOf("v.png");
    write("v.png", whole.substr(0, whole.size() - 20));
    EXPECT_EQ(message("v.png", "views"),
              "x.toml:7:17: lens.file: v.png: PNG 32x16: the file is cut short");
    write("v.png", whole.substr(0, 20));
    EXPECT_EQ(message("v.png", "views"),
              "x.toml:7:17: lens.file: v.png: PNG: the file is cut short");
}

} // namespace
} // namespace autostereo::config
