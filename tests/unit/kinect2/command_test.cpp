#include "devices/kinect2/command.hpp"

#include "tests/support/kinect2_unit.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace autostereo::test {
namespace {

using namespace devices::kinect2;

TEST(Command, IsEncodedAsTheCameraReadsIt) {
    const auto bytes = encodeCommand(7, Command::ReadPage, kPageBytes, {3});
    std::array<std::uint32_t, 6> words{};
    ASSERT_EQ(bytes.size(), sizeof words);
    std::memcpy(words.data(), bytes.data(), sizeof words);
    EXPECT_EQ(words, (std::array<std::uint32_t, 6>{0x06022009, 7, 0x1c0000, 0x22, 0, 3}));
    EXPECT_EQ(encodeCommand(0, Command::InitStreams, 0, {}).size(), 20U);
    EXPECT_EQ(encodeCommand(0, Command::SetMode, 0, {1, 0x00640064, 0, 0}).size(), 36U);
}

TEST(Command, CompletionsAreChecked) {
    EXPECT_EQ(problemWithCompletion(completion(7), 7), std::nullopt);
    EXPECT_EQ(problemWithCompletion(completion(7, 5), 7), "status 5 instead of 0");
    EXPECT_EQ(problemWithCompletion(completion(6), 7), "the completion of command 6 instead of 7");
    EXPECT_EQ(problemWithCompletion(Bytes(15), 7), "a completion of 15 bytes instead of 16");
    EXPECT_EQ(problemWithCompletion(Bytes(16), 7), "no completion after its data");
}

TEST(Command, RepliesAreRead) {
    Bytes versions(kVersionsBytes);
    constexpr std::uint32_t kMajor = 4U << 16U, kBuild = 3911;
    std::memcpy(versions.data() + 48, &kMajor, sizeof kMajor);
    std::memcpy(versions.data() + 52, &kBuild, sizeof kBuild);
    EXPECT_EQ(firmwareVersion(versions), "4.0.3911");
    EXPECT_EQ(firmwareVersion(Bytes(63)), "unknown");

    Bytes serial(kSerialBytes);
    serial[0] = std::byte{'0'};
    serial[2] = std::byte{'A'};
    serial[4] = std::byte{'\n'};
    serial[6] = std::byte{'B'};
    EXPECT_EQ(serialNumber(serial), "0A") << "ends at what is no letter or digit";
    EXPECT_EQ(serialNumber({}), "");

    EXPECT_TRUE(isReady(Bytes{std::byte{0x83}, std::byte{0x26}, std::byte{0}, std::byte{0}}));
    EXPECT_FALSE(isReady(Bytes{std::byte{0x82}, std::byte{0x26}, std::byte{0}, std::byte{0}}));
    EXPECT_FALSE(isReady(Bytes{std::byte{1}}));
}

} // namespace
} // namespace autostereo::test
