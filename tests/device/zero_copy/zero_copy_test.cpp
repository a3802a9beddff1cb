// Pictures that go from a camera's driver to the GPU without a copy: not a byte differs, and where
// a way does not work the next one is in use without anybody noticing.

#include "tests/device/v4l2/uvc_fixture.hpp"
#include "tests/device/zero_copy/zero_copy_fixture.hpp"

#include <array>
#include <iostream>
#include <stdexcept>

namespace autostereo::test {
namespace {

using namespace std::chrono_literals;
using devices::PixelWay;

class ZeroCopyFramesTest : public ZeroCopyTest {
  protected:
    /// What became of pictures, each compared with what the host's bytes become.
    struct Tally {
        std::array<int, 3> ways{};
        std::size_t different = 0, compared = 0; ///< bytes
        int wrongMarks = 0, marked = 0;          ///< blocks
        [[nodiscard]] int of(PixelWay way) const { return ways[static_cast<std::size_t>(way)]; }
    };
    Tally show(Stream& stream, int frames) {
        Tally tally;
        for (int i = 0; i < frames; ++i) {
            devices::Frame color = stream.next();
            EXPECT_FALSE(color.empty()) << stream.lost;
            if (color.empty()) break;
            showOne(std::move(color), tally);
        }
        return tally;
    }
    void showOne(devices::Frame color, Tally& tally) {
        devices::RgbdFrame pair, copied;
        copied.color = copyOf(color);
        pair.color = std::move(color);
        const auto before = uploader->color().width() > 0 ? seen(*uploader) : Rgba{};
        upload(*uploader, pair);
        ++tally.ways[static_cast<std::size_t>(uploader->colorWay())];
        gpu::FrameUploader plain;
        upload(plain, copied);
        const auto rgba = seen(*uploader), expected = seen(plain);
        ASSERT_EQ(rgba.size(), expected.size());
        for (std::size_t b = 0; b < rgba.size(); ++b)
            tally.different += rgba[b] != expected[b] ? 1U : 0U;
        tally.compared += rgba.size();
        if (uploader->colorWay() == PixelWay::Filled && before.size() == rgba.size())
            judgeMarks(before, rgba, tally);
    }
    /// A block is marked where any of its pixels became another, and nowhere else.
    void judgeMarks(const Rgba& before, const Rgba& after, Tally& tally) {
        const gpu::gl::Texture& marks = uploader->colorMarks().texture();
        const auto across = static_cast<std::size_t>(marks.width());
        const auto width = static_cast<std::size_t>(uploader->color().width());
        std::vector<std::uint8_t> read(across * static_cast<std::size_t>(marks.height()));
        std::vector<std::uint8_t> truth(read.size());
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTextureImage(marks.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_BYTE,
                          static_cast<GLsizei>(read.size()), read.data());
        for (std::size_t b = 0; b < after.size(); ++b)
            if (before[b] != after[b]) {
                const std::size_t x = b / 4 % width, y = b / 4 / width;
                truth[y / gpu::BlockMarks::kBlock * across + x / gpu::BlockMarks::kBlock] = 1;
            }
        for (std::size_t block = 0; block < read.size(); ++block) {
            tally.wrongMarks += read[block] != truth[block] ? 1 : 0;
            tally.marked += truth[block];
        }
    }
};

TEST_F(ZeroCopyFramesTest, VividsPicturesAreTheSameInEveryFormat) {
    if (IsSkipped()) return;
    Vivid::set("OSD Text Mode", 0); // a clock, so that some blocks change
    for (const char* format : {"YUYV", "UYVY", "NV12", "GREY", "RGB3", "BGR3"}) {
        SCOPED_TRACE(format);
        Stream stream(std::string(kVivid) + format);
        const Tally tally = show(stream, 10);
        EXPECT_EQ(tally.different, 0U) << "of " << tally.compared;
        EXPECT_EQ(tally.of(PixelWay::Filled), 9) << "only the first is copied";
        EXPECT_EQ(tally.wrongMarks, 0);
        EXPECT_GT(tally.marked, 0) << "nothing changed";
        std::cout << format << ": " << tally.different << " of " << tally.compared
                  << " bytes differ, " << tally.of(PixelWay::Filled) << " of 10 not copied\n";
    }
}

/// Of GPU memory that cannot be had, or that no driver takes.
class BadMemory final : public devices::PixelMemory {
  public:
    explicit BadMemory(bool none) : none_(none) {}
    devices::UniqueFd allocate(std::size_t rowBytes, std::size_t rows) override {
        if (none_) throw std::runtime_error("there is none");
        devices::UniqueFd file(memfd_create("no dmabuf", MFD_CLOEXEC));
        EXPECT_EQ(ftruncate(file.get(), static_cast<off_t>(rowBytes * rows)), 0);
        return file;
    }

  private:
    bool none_;
};

TEST_F(ZeroCopyFramesTest, WhatCannotBeFilledIsExportedAndWhatIsReadWronglyIsCopied) {
    if (IsSkipped()) return;
    for (const bool none : {true, false}) {
        SCOPED_TRACE(none ? "no memory" : "no dmabuf");
        Stream stream(std::string(kVivid) + "YUYV");
        devices::Frame first = stream.next();
        ASSERT_FALSE(first.empty()) << stream.lost;
        ASSERT_TRUE(first.shared());
        devices::PixelSharing& sharing = *first.shared()->sharing;
        sharing.offer(std::make_shared<BadMemory>(none));
        EXPECT_EQ(sharing.way(), PixelWay::Filled);
        const devices::Frame second = stream.next();
        ASSERT_FALSE(second.empty()) << stream.lost;
        EXPECT_EQ(sharing.way(), PixelWay::Exported);
        EXPECT_EQ(second.metadata().sequence, first.metadata().sequence + 1);
        // llvmpipe takes the driver's memory, but reads nothing there.
        const Tally tally = show(stream, 8);
        forgiveErrors(); // that it cannot
        EXPECT_EQ(tally.different, 0U) << "of " << tally.compared;
        EXPECT_EQ(tally.of(PixelWay::Copied), 8);
        EXPECT_EQ(sharing.way(), PixelWay::Copied);
    }
}

TEST_F(ZeroCopyFramesTest, WhatIsAllTheSameProvesNothing) {
    if (IsSkipped()) return;
    constexpr int kBlack = 5;
    Vivid::set("Test Pattern", kBlack);
    Stream stream(std::string(kVivid) + "RGB3");
    Tally tally = show(stream, 6);
    EXPECT_EQ(tally.of(PixelWay::Copied), 6) << "zeros are what unreadable memory gives";
    EXPECT_EQ(tally.different, 0U);
    Vivid::set("Test Pattern", 0);
    tally = show(stream, 12);
    EXPECT_GE(tally.of(PixelWay::Filled), 6);
    EXPECT_EQ(tally.different, 0U);
}

TEST_F(ZeroCopyFramesTest, WhoeverKeepsPicturesLosesNone) {
    if (IsSkipped()) return;
    Stream stream(std::string(kVivid) + "YUYV");
    EXPECT_EQ(show(stream, 4).of(PixelWay::Filled), 3);
    std::vector<devices::Frame> kept;
    std::vector<std::vector<std::byte>> bytes;
    int copies = 0;
    for (int i = 0; i < 20; ++i) { // more than there are buffers
        kept.push_back(stream.next());
        ASSERT_FALSE(kept.back().empty()) << stream.lost;
        copies += kept.back().shared()->fd < 0 ? 1 : 0;
        bytes.emplace_back(kept.back().pixels().begin(), kept.back().pixels().end());
        if (i > 0) {
            EXPECT_EQ(kept.back().metadata().sequence,
                      kept[kept.size() - 2].metadata().sequence + 1);
        }
    }
    // Of sixteen buffers the driver keeps three, and the last picture shown may hold one.
    EXPECT_GE(copies, 7);
    EXPECT_LE(copies, 8);
    for (std::size_t i = 0; i < kept.size(); ++i)
        EXPECT_TRUE(std::ranges::equal(kept[i].pixels(), bytes[i])) << "written over: " << i;
    kept.clear();
    EXPECT_GE(show(stream, 4).of(PixelWay::Filled), 3);
}

TEST_F(ZeroCopyFramesTest, UnpluggedWithPicturesHeldItLeavesNothingBehind) {
    if (IsSkipped()) return;
    Stream stream(std::string(kVivid) + "YUYV");
    std::size_t files = 0;
    constexpr int kRounds = 20;
    for (int round = 0; round <= kRounds; ++round) {
        SCOPED_TRACE(round);
        Tally tally = show(stream, 3);
        EXPECT_GE(tally.of(PixelWay::Filled), round == 0 ? 2 : 3) << "agreed once and for all";
        std::array<devices::Frame, 3> held;
        for (devices::Frame& frame : held)
            frame = stream.next();
        Vivid::unbind();
        while (!stream.next().empty()) {
        }
        EXPECT_NE(stream.lost, "");
        stream.source.reset();
        for (devices::Frame& frame : held) // the memory is still there
            showOne(std::move(frame), tally);
        EXPECT_EQ(tally.different, 0U);
        Vivid::bind();
        held = {};
        ASSERT_TRUE(stream.opensAgain());
        if (round == 0) files = openFiles();
    }
    EXPECT_EQ(openFiles(), files) << "after " << kRounds << " unplugs";
    std::cout << kRounds << " unplugs, " << files << " descriptors before and " << openFiles()
              << " after\n";
}

TEST_F(ZeroCopyFramesTest, WhatTheHostNeedsIsCopied) {
    if (IsSkipped()) return;
    Stream off(std::string(kVivid) + "YUYV&zero_copy=off");
    EXPECT_FALSE(off.next().shared());
    off.source.reset();
    Stream padded("v4l2:/dev/video0?format=XR24&size=640x480"); // needs no conversion
    EXPECT_EQ(show(padded, 4).of(PixelWay::Copied), 4);
    padded.source.reset();
    gpu::ColorHoldParams noisy;
    noisy.sigma = 1.5; // held on the host
    uploader.emplace(noisy);
    Stream held(std::string(kVivid) + "YUYV");
    for (int i = 0; i < 4; ++i) {
        devices::RgbdFrame pair;
        pair.color = held.next();
        ASSERT_FALSE(pair.color.empty()) << held.lost;
        EXPECT_LT(pair.color.shared()->fd, 0);
        upload(*uploader, pair);
        EXPECT_EQ(uploader->colorWay(), PixelWay::Copied);
    }
}

class ZeroCopyUvcTest : public ZeroCopyFramesTest {
  protected:
    void SetUp() override {
        if (!usbip::Plug::possible()) GTEST_SKIP() << "no virtual USB ports: run in the guest";
        ZeroCopyFramesTest::SetUp();
    }
    static UvcParams camera() {
        UvcParams all;
        UvcFormat jpeg{UvcFormat::Kind::Mjpeg, 640, 480, {jpegPicture(640, 480, 1)}};
        all.formats = {UvcFormat{UvcFormat::Kind::Yuyv, 320, 240, {}}, jpeg};
        return all;
    }
};

TEST_F(ZeroCopyUvcTest, AUsbCamerasPicturesAreTheSame) {
    if (IsSkipped()) return;
    UvcCamera emulated(camera());
    const usbip::Plug plug(emulated, usbip::Speed::High);
    const auto isThere = [] {
        return std::ranges::any_of(devices::v4l2::findCameras(),
                                   [](const auto& node) { return node.serial == "UVC0001"; });
    };
    ASSERT_TRUE(within2s(isThere));
    {
        Stream stream("v4l2:serial=UVC0001?format=YUYV");
        const Tally tally = show(stream, 30);
        EXPECT_EQ(tally.different, 0U) << "of " << tally.compared;
        EXPECT_GE(tally.of(PixelWay::Filled), 28); // the first, and a grey one that proves nothing
        EXPECT_EQ(tally.wrongMarks, 0);
        std::cout << "UVC: " << tally.different << " of " << tally.compared << " bytes differ, "
                  << tally.of(PixelWay::Filled) << " of 30 not copied\n";
    }
    Stream jpeg("v4l2:serial=UVC0001?format=MJPG");
    const devices::Frame frame = jpeg.next();
    ASSERT_FALSE(frame.empty()) << jpeg.lost;
    EXPECT_FALSE(frame.shared()) << "the host decodes it";
}

} // namespace
} // namespace autostereo::test
