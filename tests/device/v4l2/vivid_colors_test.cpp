// The kernel's test pattern camera in every format that we take: its colours come out as they are
// defined, and sizes and rates are those that the driver agreed to.

#include "tests/device/v4l2/vivid_gl_fixture.hpp"
#include "tests/oracle/color_oracle.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace autostereo::test {
namespace {

using devices::PixelFormat;

struct Case {
    const char* format;
    PixelFormat pixels;
    int width, height;
};

/// vivid has five sizes for webcams; each size with several formats, each format with several
/// sizes.
std::vector<Case> cases() {
    std::vector<Case> all;
    constexpr std::array<std::pair<const char*, PixelFormat>, 9> kFormats{
        {{"NV12", PixelFormat::Nv12},
         {"YUYV", PixelFormat::Yuyv},
         {"UYVY", PixelFormat::Uyvy},
         {"RGB3", PixelFormat::Rgb8},
         {"BGR3", PixelFormat::Bgr8},
         {"XR24", PixelFormat::Bgra8},
         {"AR24", PixelFormat::Bgra8},
         {"BGR4", PixelFormat::Bgra8},
         {"GREY", PixelFormat::Grey8}}};
    constexpr std::array<std::array<int, 2>, 3> kSizes{{{320, 180}, {640, 480}, {1280, 720}}};
    for (const auto& [format, pixels] : kFormats)
        for (const auto& [width, height] : kSizes)
            all.push_back({format, pixels, width, height});
    return all;
}

class VividColorsTest : public VividGlTest {
  protected:
    /// Through the program's own conversion.
    Rgba converted(devices::Frame color) {
        devices::RgbdFrame pair;
        pair.color = std::move(color);
        upload(*uploader, pair);
        return seen(*uploader);
    }
    static void expectBar(const oracle::ColorFrame& frame, const std::vector<std::uint8_t>& rgba,
                          std::size_t bar, int y);
};

/// White, yellow, cyan, green, magenta, red, blue, black; three quarters of 255.
constexpr std::array<std::array<int, 3>, 8> kBars{{{191, 191, 191},
                                                   {191, 191, 0},
                                                   {0, 191, 191},
                                                   {0, 191, 0},
                                                   {191, 0, 191},
                                                   {191, 0, 0},
                                                   {0, 0, 191},
                                                   {0, 0, 0}}};

bool isYuv(PixelFormat format) {
    return format == PixelFormat::Yuyv || format == PixelFormat::Uyvy ||
           format == PixelFormat::Nv12;
}

/// BT.601, limited range: what a webcam's bytes are by default.
std::array<double, 3> yCbCrOf(const std::array<int, 3>& rgb) {
    const double r = rgb[0] / 255.0, g = rgb[1] / 255.0, b = rgb[2] / 255.0;
    const double y = 0.299 * r + 0.587 * g + 0.114 * b;
    return {16 + 219 * y, 128 + 224 * (b - y) / 1.772, 128 + 224 * (r - y) / 1.402};
}

/// Y, Cb and Cr as the camera sent them, where all around is of one colour.
std::array<double, 3> bytesAt(const oracle::ColorFrame& frame, int x, int y) {
    const auto width = static_cast<std::size_t>(frame.form.width);
    const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
    std::size_t luma = row * width + column;
    if (frame.form.format != PixelFormat::Nv12)
        luma = 2 * luma + (frame.form.format == PixelFormat::Uyvy ? 1 : 0);
    return {frame.at(luma), oracle::chromaAt(frame, x, y, false),
            oracle::chromaAt(frame, x, y, true)};
}

void VividColorsTest::expectBar(const oracle::ColorFrame& frame,
                                const std::vector<std::uint8_t>& rgba, std::size_t bar, int y) {
    const int x = (2 * static_cast<int>(bar) + 1) * frame.form.width / 16;
    const std::uint8_t* pixel =
        &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.form.width) +
                   static_cast<std::size_t>(x))];
    std::array<double, 3> expected{};
    std::ranges::copy(kBars[bar], expected.begin());
    double tolerance = 0; // RGB: no arithmetic on the way
    if (frame.form.format == PixelFormat::Grey8) {
        // vivid weighs as BT.709 does, in integers.
        expected.fill(0.2126 * expected[0] + 0.7152 * expected[1] + 0.0722 * expected[2]);
        tolerance = 2;
    }
    if (isYuv(frame.form.format)) {
        // The bytes are the bar's own, but vivid's coefficients have eight bits and it rounds
        // down: up to 1.34 levels. Ours is the way back from them.
        const auto sent = bytesAt(frame, x, y), meant = yCbCrOf(kBars[bar]);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(sent[c], meant[c], 1.4)
                << "bar " << bar << " row " << y << " component " << c;
        expected = oracle::convertedColor(frame, x, y);
        tolerance = 0.51; // half a level of rounding, and float against double
    }
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(pixel[c], expected[c], tolerance)
            << "bar " << bar << " row " << y << " channel " << c;
}

TEST_F(VividColorsTest, BarsHaveTheirColoursInEveryFormatAndSize) {
    if (IsSkipped()) return;
    for (const Case& one : cases()) {
        SCOPED_TRACE(std::string(one.format) + ' ' + std::to_string(one.width));
        Stream stream("v4l2:/dev/video0?format=" + std::string(one.format) +
                      "&size=" + std::to_string(one.width) + "x" + std::to_string(one.height));
        devices::Frame frame = stream.next();
        ASSERT_FALSE(frame.empty()) << stream.lost;
        const devices::FrameMetadata form = frame.metadata();
        ASSERT_EQ(form.format, one.pixels);
        ASSERT_EQ(form.width, one.width);
        ASSERT_EQ(form.height, one.height);
        const std::vector<std::byte> bytes(frame.pixels().begin(), frame.pixels().end());
        const auto rgba = converted(std::move(frame));
        for (std::size_t bar = 0; bar < kBars.size(); ++bar)
            for (const int y : {1, one.height / 2, one.height - 2})
                expectBar({form, bytes}, rgba, bar, y);
    }
}

// vivid's 16 bits are its 8 bits of grey in the upper byte; the lower one shows a wrong byte order.
TEST_F(VividColorsTest, DepthIsTakenBitForBit) {
    if (IsSkipped()) return;
    std::vector<std::byte> grey;
    {
        Stream stream("v4l2:/dev/video0?format=GREY&size=640x480");
        const devices::Frame frame = stream.next();
        grey.assign(frame.pixels().begin(), frame.pixels().end());
    }
    Stream stream("v4l2:/dev/video0?as=depth&format=Y16&size=640x480&unit_mm=0.25");
    const devices::Frame frame = stream.next();
    ASSERT_FALSE(frame.empty()) << stream.lost;
    EXPECT_EQ(frame.metadata().format, PixelFormat::Depth16);
    EXPECT_EQ(frame.metadata().depthUnitM, 0.00025);
    ASSERT_EQ(frame.depth().size(), grey.size());
    for (std::size_t i = 0; i < grey.size(); ++i)
        ASSERT_EQ(int{frame.depth()[i]}, 256 * std::to_integer<int>(grey[i])) << "pixel " << i;
}

} // namespace
} // namespace autostereo::test
