#include "daemon/control/control_client.hpp"
#include "daemon/control/control_server.hpp"
#include "daemon/control/control_socket.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include <sys/stat.h>

namespace autostereo::daemon {
namespace {

TEST(ControlSocket, RootOurselvesAndTheGroupAreAllowed) {
    const Peer stranger{1000, {1000, 44, 27}};
    EXPECT_TRUE(isAllowed({0, {}}, 990, std::nullopt));
    EXPECT_TRUE(isAllowed({990, {}}, 990, std::nullopt));
    EXPECT_FALSE(isAllowed(stranger, 990, std::nullopt));
    EXPECT_FALSE(isAllowed(stranger, 990, 45));
    EXPECT_TRUE(isAllowed(stranger, 990, 27)) << "the last of its groups";
    EXPECT_FALSE(isAllowed({1000, {}}, 990, 0)) << "no group is no member of root's";
}

TEST(ControlSocket, IsOpenToItsGroupAndNobodyElseWhateverTheUmask) {
    const test::ScratchFolder folder;
    const mode_t before = ::umask(0);
    const auto open = listenAt(folder / "a.sock", std::nullopt);
    ::umask(0177);
    const auto shut = listenAt(folder / "b.sock", std::nullopt);
    ::umask(before);
    for (const char* name : {"a.sock", "b.sock"}) {
        struct stat found {};
        ASSERT_EQ(::stat((folder / name).c_str(), &found), 0);
        EXPECT_EQ(found.st_mode & 0777, 0660U) << name;
    }
}

TEST(ControlSocket, WhatIsInTheWayIsNotRemoved) {
    const test::ScratchFolder folder;
    const auto file = folder.write("notes.txt", "precious");
    EXPECT_THROW((void)listenAt(file, std::nullopt), ControlError);
    EXPECT_TRUE(std::filesystem::exists(file));
    EXPECT_THROW((void)listenAt(folder / std::string(200, 'x'), std::nullopt), ControlError);
    EXPECT_THROW((void)groupNamed("no such group"), ControlError);
}

// Nobody takes the request: the server still ends at once.
TEST(ControlServer, AnswersWhatIsTakenAndEndsWithRequestsOpen) {
    const test::ScratchFolder folder;
    devices::UniqueFd waiting;
    {
        ControlServer server(folder / "c.sock", std::nullopt);
        std::jthread client([&] {
            const auto socket = connectTo(folder / "c.sock");
            EXPECT_EQ(ask(socket.get(), ShowRequest{"x"}).line, "{\"ok\":true}");
        });
        std::optional<ControlServer::Asked> asked;
        while (!asked)
            asked = server.take();
        EXPECT_EQ(std::get<ShowRequest>(asked->request).what, "x");
        server.answer(asked->client, {"{\"ok\":true}"});
        server.answer(asked->client + 99, {"{}"}); // nobody's
        client.join();
        waiting = connectTo(folder / "c.sock");
        const std::string line = requestLine(StatusRequest{}) + '\n';
        ASSERT_EQ(::write(waiting.get(), line.data(), line.size()),
                  static_cast<ssize_t>(line.size()));
    }
    EXPECT_THROW((void)ask(waiting.get(), StatusRequest{}), std::runtime_error);
    EXPECT_FALSE(std::filesystem::exists(folder / "c.sock"));
}

// More than a socket's buffer holds, to a client that takes its time.
TEST(ControlServer, SendsBytesBehindTheLine) {
    const test::ScratchFolder folder;
    ControlServer server(folder / "c.sock", std::nullopt);
    std::vector<std::uint8_t> bytes(5'000'001);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::uint8_t>(i * 7 / 3);
    std::vector<std::uint8_t> received;
    std::jthread client([&] {
        const auto socket = connectTo(folder / "c.sock");
        received = ask(socket.get(), SnapshotRequest{}).bytes;
    });
    std::optional<ControlServer::Asked> asked;
    while (!asked)
        asked = server.take();
    server.answer(asked->client, {"{\"ok\":true,\"bytes\":5000001}",
                                  std::make_shared<const std::vector<std::uint8_t>>(bytes)});
    client.join();
    EXPECT_TRUE(received == bytes);
}

} // namespace
} // namespace autostereo::daemon
