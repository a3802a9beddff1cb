#include "devices/kinect2/color_packets.hpp"

#include "tests/support/kinect2_unit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace autostereo::test {
namespace {

using namespace devices::kinect2;

/// Picture k is `size + k` bytes of k.
Bytes picture(std::size_t size, unsigned k) { return Bytes(size + k, static_cast<std::byte>(k)); }

/// In transfers of 16 KiB, the last one short.
std::vector<Bytes> transfersOf(const Bytes& packet) {
    constexpr std::size_t kTransfer = 16384;
    std::vector<Bytes> result;
    for (std::size_t at = 0; at < packet.size(); at += kTransfer) {
        const auto first = packet.begin() + static_cast<std::ptrdiff_t>(at);
        result.emplace_back(
            first, first + static_cast<std::ptrdiff_t>(std::min(kTransfer, packet.size() - at)));
    }
    return result;
}

std::vector<std::uint32_t> received(const std::vector<Bytes>& transfers, ColorPackets& packets) {
    std::vector<std::uint32_t> result;
    for (const Bytes& transfer : transfers) {
        const auto packet = packets.append(transfer);
        if (!packet) continue;
        result.push_back(packet->sequence);
        const Bytes sent = picture(70000, packet->sequence);
        EXPECT_GE(packet->jpeg.size(), sent.size());
        EXPECT_LE(packet->jpeg.size(), sent.size() + 3) << "at most padding to four bytes";
        EXPECT_TRUE(std::equal(sent.begin(), sent.end(), packet->jpeg.begin()));
        EXPECT_EQ(packet->timestamp, 266 * packet->sequence);
        EXPECT_EQ(packet->exposureMs, 10);
        EXPECT_EQ(packet->digitalGain, 1.5F);
        EXPECT_EQ(packet->analogGain, 2.5F);
    }
    return result;
}

class ColorPacketsTest : public testing::Test {
  protected:
    ColorPacketsTest() {
        for (std::uint32_t k = 0; k < 4; ++k)
            for (Bytes& transfer : transfersOf(colorPacket(picture(70000, k), k, 266 * k)))
                transfers.push_back(std::move(transfer));
    }
    static constexpr std::size_t kPerPicture = 5;
    std::vector<Bytes> transfers;
    ColorPackets packets;
};

TEST_F(ColorPacketsTest, PicturesComeOutAsTheyWereSent) {
    EXPECT_EQ(received(transfers, packets), (std::vector<std::uint32_t>{0, 1, 2, 3}));
    EXPECT_EQ(packets.counters().broken, 0U);
}

TEST_F(ColorPacketsTest, ALostTransferCostsItsPicture) {
    transfers.erase(transfers.begin() + kPerPicture + 2);
    EXPECT_EQ(received(transfers, packets), (std::vector<std::uint32_t>{0, 2, 3}));
    EXPECT_EQ(packets.counters().broken, 1U);
}

TEST_F(ColorPacketsTest, ALostEndCostsTwoPictures) {
    transfers.erase(transfers.begin() + 2 * kPerPicture - 1);
    EXPECT_EQ(received(transfers, packets), (std::vector<std::uint32_t>{0, 3}));
    EXPECT_EQ(packets.counters().broken, 1U);
}

TEST_F(ColorPacketsTest, JoinsInTheMiddle) {
    transfers.erase(transfers.begin(), transfers.begin() + 3);
    EXPECT_EQ(received(transfers, packets), (std::vector<std::uint32_t>{1, 2, 3}));
}

TEST_F(ColorPacketsTest, AStreamWithoutEndsIsGivenUp) {
    const Bytes noise(16384, std::byte{0x5a});
    for (int i = 0; i < 1000; ++i)
        EXPECT_FALSE(packets.append(noise));
    EXPECT_GE(packets.counters().broken, 3U);
    packets.reset();
    EXPECT_EQ(received(transfers, packets).size(), 4U);
}

TEST(ColorPacket, FieldsThatDisagreeAreRefused) {
    const Bytes good = colorPacket(picture(5000, 0), 7, 1);
    ASSERT_TRUE(parseColorPacket(good));
    // Header's sequence and mark; footer's mark, sequence, filler, second mark, size.
    for (const std::size_t at : {std::size_t{0}, std::size_t{4}, good.size() - 56, good.size() - 52,
                                 good.size() - 46, good.size() - 24, good.size() - 20}) {
        Bytes bad = good;
        bad[at] ^= std::byte{0x40};
        EXPECT_FALSE(parseColorPacket(bad)) << at;
    }
    for (const std::size_t size : {std::size_t{0}, std::size_t{63}, good.size() - 1})
        EXPECT_FALSE(parseColorPacket(std::span(good).first(size)));
}

} // namespace
} // namespace autostereo::test
