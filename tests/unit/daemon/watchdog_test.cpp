#include "daemon/session/watchdog.hpp"
#include "tests/support/fake_clock.hpp"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

using namespace autostereo;
using namespace std::chrono_literals;

namespace {

/// The service manager's end of the notify socket.
class NotifySocket {
  public:
    NotifySocket() : descriptor_(socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0)) {
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        std::strncpy(address.sun_path, path_.c_str(), sizeof(address.sun_path) - 1);
        EXPECT_EQ(bind(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)),
                  0)
            << std::strerror(errno);
        setenv("NOTIFY_SOCKET", path_.c_str(), 1);
    }
    NotifySocket(const NotifySocket&) = delete;
    NotifySocket& operator=(const NotifySocket&) = delete;
    ~NotifySocket() {
        unsetenv("NOTIFY_SOCKET");
        unsetenv("WATCHDOG_USEC");
        close(descriptor_);
        std::filesystem::remove(path_);
    }

    /// The next message, or "" if there is none.
    [[nodiscard]] std::string receive() const {
        std::array<char, 256> message{};
        const ssize_t length = recv(descriptor_, message.data(), message.size(), 0);
        return length > 0 ? std::string(message.data(), static_cast<std::size_t>(length)) : "";
    }

  private:
    std::string path_ =
        std::filesystem::temp_directory_path() / ("autostereo-notify-" + std::to_string(getpid()));
    int descriptor_;
};

TEST(Watchdog, SaysReadyThenAliveAtHalfTheTimeThenStopping) {
    const NotifySocket manager;
    setenv("WATCHDOG_USEC", "2000000", 1);
    test::FakeClock clock;
    daemon::Watchdog watchdog(clock);
    EXPECT_EQ(manager.receive(), "");
    clock.advance(5s); // building the pipeline takes its time
    watchdog.ready();
    EXPECT_EQ(manager.receive(), "READY=1");
    clock.advance(999ms);
    watchdog.pet();
    EXPECT_EQ(manager.receive(), "");
    clock.advance(1ms);
    watchdog.pet();
    watchdog.pet();
    EXPECT_EQ(manager.receive(), "WATCHDOG=1");
    EXPECT_EQ(manager.receive(), "");
    clock.advance(1s);
    watchdog.pet();
    EXPECT_EQ(manager.receive(), "WATCHDOG=1");
    watchdog.stopping();
    EXPECT_EQ(manager.receive(), "STOPPING=1");
    EXPECT_EQ(manager.receive(), "");
}

TEST(Watchdog, IsNotPettedWhereNobodyWatches) {
    const NotifySocket manager;
    test::FakeClock clock;
    daemon::Watchdog watchdog(clock);
    watchdog.ready();
    EXPECT_EQ(manager.receive(), "READY=1");
    clock.advance(1h);
    watchdog.pet();
    EXPECT_EQ(manager.receive(), "");
}

TEST(Watchdog, DoesNothingWithoutASocket) {
    unsetenv("NOTIFY_SOCKET");
    test::FakeClock clock;
    daemon::Watchdog watchdog(clock);
    watchdog.ready();
    clock.advance(1h);
    watchdog.pet();
    watchdog.stopping();
}

} // namespace
