// Real datagrams over the loopback.

#include "devices/input.hpp"
#include "devices/tracking/open_eyes.hpp"
#include "devices/tracking/opentrack_source.hpp"
#include "tests/unit/tracking/opentrack_bytes.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <chrono>
#include <functional>
#include <limits>
#include <thread>

namespace autostereo::test {
namespace {

using devices::OpentrackSource;
using namespace std::chrono_literals;

constexpr glm::dvec3 kNominal{0, 0, 0.65};

/// Sends to a port of the loopback.
class Sender {
  public:
    explicit Sender(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_DGRAM, 0)) {
        to_.sin_family = AF_INET;
        to_.sin_port = htons(port);
        to_.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    }
    void send(const std::vector<std::byte>& bytes) {
        ASSERT_EQ(::sendto(socket_.get(), bytes.data(), bytes.size(), 0,
                           reinterpret_cast<const sockaddr*>(&to_), sizeof to_),
                  static_cast<ssize_t>(bytes.size()));
    }

  private:
    devices::UniqueFd socket_;
    sockaddr_in to_{};
};

class OpentrackSourceTest : public testing::Test {
  protected:
    void SetUp() override { ASSERT_TRUE(sentArrive({1, 2, 3, 0, 0, 0})); }

    bool eventually(const std::function<bool()>& holds) {
        const auto until = clock.now() + 10s;
        while (!holds() && clock.now() < until)
            std::this_thread::sleep_for(1ms);
        return holds();
    }
    bool sentArrive(const std::array<double, 6>& numbers) {
        const auto before = source.counters().received;
        sender.send(opentrackBytes(numbers));
        return eventually([&] { return source.counters().received > before; });
    }
    std::optional<devices::EyeSample> newest() {
        std::optional<devices::EyeSample> found;
        while (auto sample = source.next(clock.now()))
            found = sample;
        return found;
    }

    devices::SteadyClock clock;
    OpentrackSource source{"127.0.0.1", 0, {}, kNominal, clock};
    Sender sender{source.port()};
};

TEST_F(OpentrackSourceTest, AHeadArrivesWithItsTime) {
    const auto before = clock.now();
    ASSERT_TRUE(sentArrive({10, 0, 5, 0, 0, 0}));
    std::optional<devices::EyeSample> sample;
    ASSERT_TRUE(eventually([&] {
        if (const auto found = newest()) sample = found;
        return sample && sample->at >= before;
    }));
    EXPECT_LE(sample->at, clock.now());
    EXPECT_NEAR(sample->eyes.middle().x, 0.1, 1e-12);
    EXPECT_NEAR(sample->eyes.middle().z, 0.6, 1e-12);
    EXPECT_NEAR(sample->eyes.right.x - sample->eyes.left.x, 0.063, 1e-12);
}

TEST_F(OpentrackSourceTest, DamageIsDroppedAndCounted) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<std::vector<std::byte>> wrong;
    for (const std::size_t size : {0U, 1U, 47U, 49U, 96U, 97U, 1472U, 60000U})
        wrong.emplace_back(size);
    wrong.push_back(opentrackBytes({nan, 0, 0, 0, 0, 0}));
    wrong.push_back(opentrackBytes({0, 0, 64, 0, 0, 0})); // 1 cm in front of the panel
    for (const auto& bytes : wrong) {
        const auto before = source.counters();
        sender.send(bytes);
        ASSERT_TRUE(eventually([&] { return source.counters().damaged == before.damaged + 1; }));
        EXPECT_EQ(source.counters().accepted, before.accepted) << bytes.size();
    }
    ASSERT_TRUE(sentArrive({1, 1, 1, 0, 0, 0})); // and is none the worse for it
    EXPECT_TRUE(eventually([&] { return source.counters().accepted == 2; }));
}

TEST_F(OpentrackSourceTest, AFloodIsThinnedOutAndTheNewestWins) {
    const auto start = clock.now();
    double sent = 0;
    // 10 kHz for a second, and as fast as it goes for another.
    while (clock.now() - start < 2s) {
        sender.send(opentrackBytes({sent++ * 1e-4, 0, 0, 0, 0, 0}));
        if (clock.now() - start < 1s) std::this_thread::sleep_for(50us);
    }
    const double seconds = std::chrono::duration<double>(clock.now() - start).count();
    // Until the kernel holds nothing any more: two looks 20 ms apart see the same.
    ASSERT_TRUE(eventually([&] {
        const auto before = source.counters().received;
        std::this_thread::sleep_for(20ms);
        return source.counters().received == before;
    }));
    const auto counted = source.counters();
    std::printf("sent %.0f, received %zu, accepted %zu, limited %zu in %.1f s\n", sent,
                static_cast<std::size_t>(counted.received),
                static_cast<std::size_t>(counted.accepted),
                static_cast<std::size_t>(counted.limited), seconds);
    EXPECT_LE(static_cast<double>(counted.accepted), 500 * seconds + 2);
    EXPECT_EQ(counted.received, counted.accepted + counted.damaged + counted.limited);
    EXPECT_GT(counted.limited, 100U);
    EXPECT_EQ(counted.damaged, 0U);
    // What the program sees after the flood is of its end.
    ASSERT_TRUE(sentArrive({33, 0, 0, 0, 0, 0}));
    std::optional<devices::EyeSample> sample;
    EXPECT_TRUE(eventually([&] {
        if (const auto found = newest()) sample = found;
        return sample && std::abs(sample->eyes.middle().x - 0.33) < 1e-9;
    }));
}

std::string refusal(const std::string& uri) {
    devices::SteadyClock clock;
    devices::ViewerParams params;
    params.source = uri;
    try {
        static_cast<void>(devices::openEyes(params, kNominal, clock.now(), false, clock));
    } catch (const devices::DeviceError& error) {
        return error.what();
    }
    return "opened";
}

TEST(OpenEyes, AddressesAreRefusedInOneLine) {
    const std::string wanted = " (allowed opentrack:[ADDRESS:]PORT, 1 to 65535)";
    EXPECT_EQ(refusal("opentrack:"), "opentrack:: port ''" + wanted);
    EXPECT_EQ(refusal("opentrack:0"), "opentrack:0: port '0'" + wanted);
    EXPECT_EQ(refusal("opentrack:65536"), "opentrack:65536: port '65536'" + wanted);
    EXPECT_EQ(refusal("opentrack:4242x"), "opentrack:4242x: port '4242x'" + wanted);
    EXPECT_EQ(
        refusal("opentrack:0.0.0.0:4242"),
        "opentrack: cannot listen on 0.0.0.0:4242: all addresses at once; name this machine's "
        "own one");
    EXPECT_EQ(refusal("opentrack:somewhere:4242"),
              "opentrack: cannot listen on somewhere:4242: no IPv4 address in digits");
    EXPECT_EQ(refusal("opentrack:203.0.113.1:4242"), // no machine has it (RFC 5737)
              "opentrack: cannot listen on 203.0.113.1:4242: Cannot assign requested address");
    EXPECT_EQ(refusal("opentrack:4242?rate=3"),
              "opentrack:4242?rate=3: unknown key rate (allowed none)");
    EXPECT_EQ(refusal("webcam:0"),
              "viewer: webcam:0: no tracker (allowed camera:[URI], file:TRACE, "
              "opentrack:[ADDRESS:]PORT)");
}

TEST(OpenEyes, APortThatIsTakenIsSaid) {
    devices::SteadyClock clock;
    const OpentrackSource first("127.0.0.1", 0, {}, kNominal, clock);
    const std::string port = std::to_string(first.port());
    EXPECT_EQ(refusal("opentrack:127.0.0.1:" + port),
              "opentrack: cannot listen on 127.0.0.1:" + port + ": Address already in use");
}

} // namespace
} // namespace autostereo::test
