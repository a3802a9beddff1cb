#include "devices/kinect2/depth_packets.hpp"

#include "tests/support/kinect2_unit.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace autostereo::test {
namespace {

using namespace devices::kinect2;

/// Any bytes will do: contents are not looked at here.
RawDepthFrame numberedFrame(std::uint32_t sequence) {
    RawDepthFrame frame;
    frame.sequence = sequence;
    frame.timestamp = 266 * sequence;
    std::mt19937 random(sequence);
    for (std::size_t i = 0; i < frame.bytes.size(); i += sizeof(std::uint32_t)) {
        const auto word = static_cast<std::uint32_t>(random());
        std::memcpy(frame.bytes.data() + i, &word, sizeof word);
    }
    return frame;
}

/// Frames 0, 1, 2 and 3 on one wire.
struct Wire {
    Wire() {
        for (std::uint32_t i = 0; i < 4; ++i) {
            frames.push_back(numberedFrame(i));
            for (Bytes& packet : depthPackets(frames.back()))
                packets.push_back({std::move(packet), true});
        }
    }
    struct Packet {
        Bytes bytes;
        bool intact;
    };
    static constexpr std::size_t kPerSubImage = 10;
    static constexpr std::size_t kPerFrame = 10 * kPerSubImage;

    std::vector<RawDepthFrame> frames;
    std::vector<Packet> packets;
};

/// Sequences of the frames that come out; each has to be bit-exact.
std::vector<std::uint32_t> received(const Wire& wire, DepthPackets& assembler) {
    std::vector<std::uint32_t> result;
    RawDepthFrame frame;
    for (const auto& packet : wire.packets) {
        if (!assembler.append(packet.bytes, packet.intact)) continue;
        assembler.swapFrame(frame);
        result.push_back(frame.sequence);
        const auto& sent = wire.frames.at(frame.sequence);
        EXPECT_EQ(frame.timestamp, sent.timestamp) << "its own time, not the next frame's";
        EXPECT_TRUE(frame.bytes == sent.bytes) << frame.sequence;
    }
    return result;
}

using Sequences = std::vector<std::uint32_t>;

TEST(DepthPackets, FramesComeOutAsTheyWereSent) {
    const Wire wire;
    DepthPackets assembler;
    EXPECT_EQ(received(wire, assembler), (Sequences{0, 1, 2, 3}));
    EXPECT_EQ(assembler.counters().brokenFrames, 0U);
    EXPECT_EQ(assembler.counters().brokenSubImages, 0U);
}

TEST(DepthPackets, JoinsInTheMiddle) {
    Wire wire;
    wire.packets.erase(wire.packets.begin(), wire.packets.begin() + 33);
    DepthPackets assembler;
    EXPECT_EQ(received(wire, assembler), (Sequences{1, 2, 3}));
}

/// What happens to packet 134 (frame 1, sub-image 3, fifth packet) costs that frame only.
class DamagedDepthPackets : public testing::Test {
  protected:
    static constexpr std::size_t kHit = Wire::kPerFrame + 3 * Wire::kPerSubImage + 4;
    void expectOnlyFrame1Lost() {
        DepthPackets assembler;
        EXPECT_EQ(received(wire, assembler), (Sequences{0, 2, 3}));
        EXPECT_EQ(assembler.counters().brokenFrames, 1U);
        EXPECT_EQ(assembler.counters().brokenSubImages, 1U);
    }
    [[nodiscard]] auto hit() { return wire.packets.begin() + static_cast<std::ptrdiff_t>(kHit); }
    Wire wire;
};

TEST_F(DamagedDepthPackets, ReportedByTheBus) {
    hit()->intact = false;
    expectOnlyFrame1Lost();
}

TEST_F(DamagedDepthPackets, ReportedAndEmptied) {
    *hit() = {{}, false};
    expectOnlyFrame1Lost();
}

TEST_F(DamagedDepthPackets, SilentlyLost) {
    wire.packets.erase(hit());
    expectOnlyFrame1Lost();
}

TEST_F(DamagedDepthPackets, SilentlyEmptied) {
    hit()->bytes.clear();
    DepthPackets assembler;
    EXPECT_EQ(received(wire, assembler), (Sequences{0, 2, 3}));
    EXPECT_EQ(assembler.counters().brokenFrames, 1U);
}

TEST_F(DamagedDepthPackets, Truncated) {
    hit()->bytes.resize(1000);
    expectOnlyFrame1Lost();
}

TEST_F(DamagedDepthPackets, Duplicated) {
    wire.packets.insert(hit(), *hit());
    expectOnlyFrame1Lost();
}

TEST_F(DamagedDepthPackets, TheEmptyOneReported) {
    (wire.packets.begin() + Wire::kPerFrame + 3 * Wire::kPerSubImage + 9)->intact = false;
    DepthPackets assembler;
    // The end of one sub-image is lost, so the beginning of the next cannot be told from its rest.
    EXPECT_EQ(received(wire, assembler), (Sequences{0, 2, 3}));
    EXPECT_EQ(assembler.counters().brokenFrames, 1U);
}

TEST_F(DamagedDepthPackets, TheTenthSubImageIsNotNeeded) {
    wire.packets[Wire::kPerFrame + 9 * Wire::kPerSubImage + 2].intact = false;
    DepthPackets assembler;
    EXPECT_EQ(received(wire, assembler), (Sequences{0, 1, 2, 3}));
}

TEST_F(DamagedDepthPackets, FooterThatCannotBe) {
    constexpr std::size_t kLastOfSubImage = 8, kSubsequenceAt = 16, kLengthAt = 20;
    for (const std::size_t field : {kSubsequenceAt, kLengthAt}) {
        Wire damaged;
        auto& packet =
            damaged.packets[Wire::kPerFrame + 3 * Wire::kPerSubImage + kLastOfSubImage].bytes;
        constexpr std::uint32_t kHuge = 0xffffffffU;
        std::memcpy(packet.data() + packet.size() - DepthPackets::kFooterBytes + field, &kHuge,
                    sizeof kHuge);
        DepthPackets assembler;
        EXPECT_EQ(received(damaged, assembler), (Sequences{0, 2, 3})) << field;
        EXPECT_EQ(assembler.counters().brokenFrames, 1U);
        EXPECT_EQ(assembler.counters().brokenSubImages, 1U);
    }
}

TEST(DepthPackets, SubImagesOfTwoFramesNeverMix) {
    Wire wire;
    // Sub-images 4 to 9 of frame 1 and 0 to 3 of frame 2 are gone: ten sub-images are seen.
    const auto first = wire.packets.begin() + Wire::kPerFrame + 4 * Wire::kPerSubImage;
    wire.packets.erase(first, first + Wire::kPerFrame);
    DepthPackets assembler;
    EXPECT_EQ(received(wire, assembler), (Sequences{0, 3}));
    EXPECT_EQ(assembler.counters().brokenFrames, 2U);
}

} // namespace
} // namespace autostereo::test
