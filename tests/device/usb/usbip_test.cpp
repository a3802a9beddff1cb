// Devices that are programs look like hardware to libusb, and so do their faults.

#include "tests/device/usbip/counting_device.hpp"
#include "tests/device/usbip/plug.hpp"

#include <gtest/gtest.h>

#include <libusb.h>

#include <array>
#include <memory>
#include <numeric>
#include <thread>

namespace autostereo::test {
namespace {

using namespace std::chrono_literals;
using usbip::Bytes;
using usbip::Faults;

class UsbIpTest : public testing::Test {
  protected:
    void SetUp() override {
        if (!usbip::Plug::possible()) GTEST_SKIP() << "no virtual USB ports: run in the guest";
        plugIn();
    }
    void TearDown() override { unplug(); }

    void plugIn() {
        plug = std::make_unique<usbip::Plug>(device, usbip::Speed::Super);
        for (int i = 0; i < 200 && handle == nullptr; ++i) {
            // The library hears of new devices from udev's daemon, which is not in the guest: it
            // has to look for itself, as it does when it starts.
            if (context != nullptr) libusb_exit(context);
            ASSERT_EQ(libusb_init(&context), 0);
            handle = libusb_open_device_with_vid_pid(context, CountingDevice::kVendor,
                                                     CountingDevice::kProduct);
            if (handle == nullptr) std::this_thread::sleep_for(10ms);
        }
        ASSERT_NE(handle, nullptr) << "the kernel did not take the device";
        ASSERT_EQ(libusb_claim_interface(handle, 0), 0);
    }
    void unplug() {
        if (handle != nullptr) libusb_close(handle);
        handle = nullptr;
        plug.reset();
        if (context != nullptr) libusb_exit(context);
        context = nullptr;
    }

    struct Result {
        int status;
        Bytes data;
    };
    Result bulk(std::size_t bytes = CountingDevice::kPacketBytes, unsigned timeoutMs = 1000) {
        Result result{0, Bytes(bytes)};
        int got = 0;
        result.status = libusb_bulk_transfer(handle, CountingDevice::kBulkIn, result.data.data(),
                                             static_cast<int>(bytes), &got, timeoutMs);
        result.data.resize(static_cast<std::size_t>(got));
        return result;
    }

    struct IsoResult {
        int status = -1; ///< libusb_transfer_status; -1: not submitted
        std::vector<int> packetStatus;
        std::vector<Bytes> packets;
    };
    IsoResult isochronous(int packets) {
        constexpr unsigned kBytes = 1024;
        Bytes buffer(kBytes * static_cast<unsigned>(packets));
        libusb_transfer* transfer = libusb_alloc_transfer(packets);
        int done = 0;
        libusb_fill_iso_transfer(
            transfer, handle, CountingDevice::kIsochronousIn, buffer.data(),
            static_cast<int>(buffer.size()), packets,
            [](libusb_transfer* one) { *static_cast<int*>(one->user_data) = 1; }, &done, 1000);
        libusb_set_iso_packet_lengths(transfer, kBytes);
        IsoResult result;
        if (libusb_submit_transfer(transfer) == 0) {
            while (done == 0)
                libusb_handle_events_completed(context, &done);
            result.status = transfer->status;
            for (unsigned i = 0; i < static_cast<unsigned>(packets); ++i) {
                const auto& one = transfer->iso_packet_desc[i];
                const unsigned char* data = libusb_get_iso_packet_buffer(transfer, i);
                result.packetStatus.push_back(one.status);
                result.packets.emplace_back(data, data + one.actual_length);
            }
        }
        libusb_free_transfer(transfer);
        return result;
    }

    void setFaults(std::uint8_t endpoint, const Faults& faults) {
        plug->setFaults(endpoint, faults);
        std::this_thread::sleep_for(30ms); // the plug looks every 10 ms
    }

    libusb_context* context = nullptr;
    libusb_device_handle* handle = nullptr;
    CountingDevice device;
    std::unique_ptr<usbip::Plug> plug;
};

bool countsUp(const Bytes& bytes) {
    for (std::size_t i = 1; i < bytes.size(); ++i)
        if (bytes[i] != static_cast<std::uint8_t>(bytes[i - 1] + 1)) return false;
    return true;
}

TEST_F(UsbIpTest, KernelAndLibraryTakeItForASuperSpeedDevice) {
    libusb_device* usb = libusb_get_device(handle);
    EXPECT_EQ(libusb_get_device_speed(usb), LIBUSB_SPEED_SUPER);
    std::array<unsigned char, 64> text{};
    libusb_device_descriptor about{};
    ASSERT_EQ(libusb_get_device_descriptor(usb, &about), 0);
    ASSERT_GT(libusb_get_string_descriptor_ascii(handle, about.iProduct, text.data(), 64), 0);
    EXPECT_STREQ(reinterpret_cast<char*>(text.data()), "Counting device");
    EXPECT_EQ(libusb_get_max_iso_packet_size(usb, CountingDevice::kIsochronousIn), 1024);
}

TEST_F(UsbIpTest, ControlAndBulkGoBothWays) {
    Bytes out(300);
    std::iota(out.begin(), out.end(), std::uint8_t{7});
    int sent = 0;
    ASSERT_EQ(libusb_bulk_transfer(handle, CountingDevice::kBulkOut, out.data(), 300, &sent, 1000),
              0);
    EXPECT_EQ(sent, 300);
    Bytes back(512);
    EXPECT_EQ(
        libusb_control_transfer(handle, 0xc0, CountingDevice::kEcho, 0, 0, back.data(), 512, 1000),
        300);
    back.resize(300);
    EXPECT_EQ(back, out);
    EXPECT_EQ(libusb_control_transfer(handle, 0xc0, 0x55, 0, 0, back.data(), 8, 1000),
              LIBUSB_ERROR_PIPE)
        << "an unknown request stalls";

    const Result first = bulk(), second = bulk();
    ASSERT_EQ(first.status, 0);
    Bytes both = first.data;
    both.insert(both.end(), second.data.begin(), second.data.end());
    EXPECT_EQ(both.size(), 2 * CountingDevice::kPacketBytes);
    EXPECT_TRUE(countsUp(both));
}

TEST_F(UsbIpTest, InterruptsComeWhenTheDeviceHasSomethingToSay) {
    const auto started = std::chrono::steady_clock::now();
    for (int i = 0; i < 5; ++i) {
        std::array<unsigned char, 64> data{};
        int got = 0;
        ASSERT_EQ(libusb_interrupt_transfer(handle, CountingDevice::kInterruptIn, data.data(), 64,
                                            &got, 1000),
                  0);
        EXPECT_EQ(got, 8);
    }
    // Four of the device's pauses of 20 ms lie between five of them.
    EXPECT_GE(std::chrono::steady_clock::now() - started, 80ms);
}

TEST_F(UsbIpTest, IsochronousPacketsComeOnTimeAndInOrder) {
    const auto started = std::chrono::steady_clock::now();
    Bytes all;
    for (int i = 0; i < 10; ++i) {
        const IsoResult result = isochronous(64);
        ASSERT_EQ(result.status, LIBUSB_TRANSFER_COMPLETED);
        for (const Bytes& packet : result.packets) {
            ASSERT_EQ(packet.size(), CountingDevice::kPacketBytes);
            all.insert(all.end(), packet.begin(), packet.end());
        }
    }
    EXPECT_TRUE(countsUp(all));
    // 640 intervals of 125 us.
    EXPECT_GE(std::chrono::steady_clock::now() - started, 79ms);
}

TEST_F(UsbIpTest, LostPacketsAreSaidToBeLost) {
    Faults faults;
    faults.lose = 0.3;
    setFaults(CountingDevice::kIsochronousIn, faults);
    int lost = 0;
    for (int i = 0; i < 4; ++i) {
        const IsoResult result = isochronous(64);
        for (std::size_t k = 0; k < result.packets.size(); ++k)
            if (result.packetStatus[k] != LIBUSB_TRANSFER_COMPLETED) {
                ++lost;
                EXPECT_TRUE(result.packets[k].empty());
            }
    }
    EXPECT_NEAR(lost, 0.3 * 256, 30); // four standard deviations of a binomial draw
    setFaults(CountingDevice::kBulkIn, {.lose = 1});
    EXPECT_NE(bulk().status, 0);
    setFaults(CountingDevice::kBulkIn, {});
    EXPECT_EQ(bulk().status, 0);
}

TEST_F(UsbIpTest, TruncatedDoubledAndReorderedPackets) {
    setFaults(CountingDevice::kBulkIn, {.truncate = 1});
    EXPECT_EQ(bulk().data.size(), CountingDevice::kPacketBytes / 2);
    setFaults(CountingDevice::kBulkIn, {.duplicate = 1});
    const Bytes first = bulk().data, second = bulk().data;
    EXPECT_EQ(first, second);
    Faults swapped;
    swapped.reorder = 1;
    setFaults(CountingDevice::kIsochronousIn, swapped);
    const IsoResult result = isochronous(4);
    ASSERT_EQ(result.packets.size(), 4U);
    for (const std::size_t pair : {0U, 2U}) {
        Bytes inOrder = result.packets[pair + 1];
        inOrder.insert(inOrder.end(), result.packets[pair].begin(), result.packets[pair].end());
        EXPECT_TRUE(countsUp(inOrder)) << "packets " << pair << " and the next have changed places";
    }
}

TEST_F(UsbIpTest, StallsAndSilenceLastUntilTheyAreLifted) {
    setFaults(CountingDevice::kBulkIn, {.stall = true});
    EXPECT_EQ(bulk().status, LIBUSB_ERROR_PIPE);
    setFaults(CountingDevice::kBulkIn, {.silent = true});
    EXPECT_EQ(bulk(512, 100).status, LIBUSB_ERROR_TIMEOUT);
    setFaults(CountingDevice::kBulkIn, {});
    EXPECT_EQ(bulk().status, 0);
}

TEST_F(UsbIpTest, UnpluggedInTheMiddleIsNoDevice) {
    setFaults(CountingDevice::kBulkIn, {.unplugAfter = 3});
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(bulk().status, 0);
    EXPECT_EQ(bulk().status, LIBUSB_ERROR_NO_DEVICE);
    EXPECT_FALSE(plug->plugged());
}

TEST_F(UsbIpTest, MoreThanWasAskedForIsAnOverflow) {
    Faults faults;
    faults.babble = true;
    setFaults(CountingDevice::kBulkIn, faults);
    EXPECT_EQ(bulk().status, LIBUSB_ERROR_OVERFLOW);
    setFaults(CountingDevice::kIsochronousIn, faults);
    const IsoResult result = isochronous(4);
    ASSERT_EQ(result.packetStatus.size(), 4U);
    EXPECT_EQ(result.packetStatus.front(), LIBUSB_TRANSFER_OVERFLOW);
}

TEST_F(UsbIpTest, PluggedInAgainAndAgain) {
    for (int i = 0; i < 10; ++i) {
        unplug();
        ASSERT_NO_FATAL_FAILURE(plugIn());
        EXPECT_EQ(bulk().status, 0);
    }
}

} // namespace
} // namespace autostereo::test
