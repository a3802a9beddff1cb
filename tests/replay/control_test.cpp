// A running program is asked and told through its control socket.

#include "tests/replay/kiosk.hpp"

#include "daemon/control/control_client.hpp"
#include "daemon/control/control_socket.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

namespace autostereo::test {
namespace {

using std::chrono::milliseconds;

struct Control : testing::Test {
    void SetUp() override {
        kiosk.plugBoth();
        kiosk.start();
        ASSERT_TRUE(kiosk.shows("live", milliseconds(10'000)));
    }
    void TearDown() override { EXPECT_TRUE(succeeded(kiosk.stop())); }

    /// The answer to any bytes; the connection stays open.
    [[nodiscard]] static std::string answerTo(const devices::UniqueFd& socket,
                                              const std::string& bytes) {
        (void)::send(socket.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
        std::string answer;
        for (char letter = 0; ::recv(socket.get(), &letter, 1, 0) == 1 && letter != '\n';)
            answer += letter;
        return answer;
    }
    [[nodiscard]] devices::UniqueFd connection() const { return daemon::connectTo(kiosk.socket()); }
    [[nodiscard]] std::uint64_t presented() const {
        return kiosk.status().at("report").at("frames_presented");
    }

    Kiosk kiosk;
};

TEST_F(Control, StatusForPeopleAndMachines) {
    const auto status = kiosk.status();
    EXPECT_EQ(status.at("panel").at("width"), kSmallWidth);
    EXPECT_EQ(status.at("report").at("method"), "direct");
    EXPECT_EQ(status.at("settings").at("scale"), "auto");
    EXPECT_EQ(status.at("sensors").at("depth").at("state"), "streaming");
    EXPECT_LT(status.at("sensors").at("depth").at("last_frame_ms_ago"), 500 * kSlower);
    const ProgramResult text = kiosk.command({"status"});
    EXPECT_TRUE(text.out.starts_with("shows: live for ")) << text.out;
    EXPECT_NE(text.out.find("settings: scale=auto focus=auto method=direct"), std::string::npos);
    const std::string before = text.out;
    EXPECT_TRUE(eventually([&, first = presented()] { return presented() > first; },
                           milliseconds(2000 * kSlower)));
}

struct SetPictures {
    ColorPicture deep, flat, dim;
};

/// Still cameras, so that pictures can be compared; nothing where a busy machine was slower than
/// the longest time (4 s) that the last picture stays.
std::optional<SetPictures> picturesWhileFrozen(Kiosk& kiosk) {
    kiosk.plugBoth();
    EXPECT_TRUE(succeeded(kiosk.command({"set", "mode=3d"})));
    EXPECT_TRUE(succeeded(kiosk.command({"set", "brightness=1"})));
    EXPECT_TRUE(kiosk.shows("live", milliseconds(5000)));
    kiosk.silence("depth");
    kiosk.silence("color");
    if (!kiosk.shows("frozen", milliseconds(1000))) return {};
    SetPictures pictures;
    pictures.deep = kiosk.snapshot();
    EXPECT_TRUE(succeeded(kiosk.command({"set", "mode=2d"})));
    pictures.flat = kiosk.snapshot();
    EXPECT_TRUE(succeeded(kiosk.command({"set", "brightness=0.5"})));
    pictures.dim = kiosk.snapshot();
    if (kiosk.status().at("shown") != "frozen") return {};
    return pictures;
}

TEST_F(Control, WhatIsSetIsOnTheNextPicture) {
    kiosk.silence("depth");
    kiosk.silence("color");
    kiosk.configure("idle.freeze_s = 4\n");
    ASSERT_TRUE(succeeded(kiosk.command({"reload"})));
    std::optional<SetPictures> pictures;
    for (int i = 0; i < 10 && !pictures; ++i)
        pictures = picturesWhileFrozen(kiosk);
    ASSERT_TRUE(pictures);
    const auto& [deep, flat, dim] = *pictures;
    EXPECT_NE(deep, flat);
    ASSERT_EQ(dim.rgb.size(), flat.rgb.size());
    for (std::size_t i = 0; i < flat.rgb.size(); ++i) // rounded twice: texture, blending
        ASSERT_NEAR(dim.rgb[i], flat.rgb[i] / 2.0, 1) << i;
}

TEST_F(Control, SettingsAreThoseOfTheStatus) {
    for (const char* setting : {"scale=0.25", "focus=1.5", "method=multipass", "brightness=0.75"})
        EXPECT_TRUE(succeeded(kiosk.command({"set", setting}))) << setting;
    const auto settings = kiosk.status().at("settings");
    EXPECT_EQ(settings.at("scale"), 0.25);
    EXPECT_EQ(settings.at("focus"), 1.5);
    EXPECT_EQ(settings.at("brightness"), 0.75);
    EXPECT_TRUE(eventually(
        [&] {
            const auto report = kiosk.status().at("report");
            return report.at("method") == "multipass" && report.at("depth").at("focus_m") == 1.5;
        },
        milliseconds(3000 * kSlower)));
    const ProgramResult refused = kiosk.command({"set", "scale=11"});
    EXPECT_TRUE(failedPlainly(refused, 2));
    EXPECT_EQ(refused.err, "autostereo: set scale: depth.scale: 11 is out of range (allowed 0 to "
                           "10)\n");
    EXPECT_TRUE(failedPlainly(kiosk.command({"set", "colour=red"}), 2));
}

TEST_F(Control, PatternsAreWhatThePatternCommandDraws) {
    const std::string file = kiosk.folder() / "numbers.png";
    ASSERT_TRUE(succeeded(runProgram(calling(
        {"pattern", "numbers", "--display", kiosk.folder() / "small.toml", "--output", file}))));
    ASSERT_TRUE(succeeded(kiosk.command({"set", "brightness=0.5"})));
    ASSERT_TRUE(succeeded(kiosk.command({"show", "numbers"})));
    EXPECT_EQ(kiosk.snapshot(), readColor(file)) << "not dimmed";
    EXPECT_EQ(kiosk.status().at("shown"), "pattern");
    EXPECT_TRUE(failedPlainly(kiosk.command({"show", "nothing"}), 2));
    ASSERT_TRUE(succeeded(kiosk.command({"show", "live"})));
    EXPECT_TRUE(kiosk.shows("live", milliseconds(1000)));
    EXPECT_TRUE(eventually([&] { return kiosk.snapshot() != readColor(file); },
                           milliseconds(1000 * kSlower)));
}

TEST_F(Control, AnInvalidConfigurationLeavesTheOldOneRunning) {
    kiosk.configure("depth.scale = 99\n");
    const ProgramResult refused = kiosk.command({"reload"});
    EXPECT_TRUE(failedPlainly(refused, 2));
    EXPECT_NE(refused.err.find("depth.scale: 99 is out of range"), std::string::npos);
    kiosk.program().signal(SIGHUP);
    EXPECT_TRUE(kiosk.shows("live", milliseconds(2000)));
    EXPECT_EQ(kiosk.status().at("settings").at("scale"), "auto");

    kiosk.configure("depth.scale = 0.5\nsynthesis.method = \"instanced\"\n");
    kiosk.program().signal(SIGHUP);
    EXPECT_TRUE(eventually([&] { return kiosk.status().at("settings").at("scale") == 0.5; },
                           milliseconds(3000 * kSlower)));
    EXPECT_TRUE(kiosk.shows("live", milliseconds(3000)));
    EXPECT_EQ(kiosk.status().at("report").at("method"), "instanced");
}

TEST_F(Control, AnotherInputIsTakenWhereItIsThere) {
    const auto configure = [&](const std::string& uri) {
        (void)kiosk.folder().file("kiosk.toml", "input.uri = \"" + uri + "\"\ncontrol.socket = \"" +
                                                    kiosk.socket() + "\"\n");
    };
    configure("none.mkv");
    EXPECT_TRUE(failedPlainly(kiosk.command({"reload"}), 1));
    configure("ftp:somewhere");
    EXPECT_TRUE(failedPlainly(kiosk.command({"reload"}), 2));
    EXPECT_TRUE(kiosk.shows("live", milliseconds(2000))) << "the old one runs on";
    configure(kSmallRoom);
    EXPECT_TRUE(succeeded(kiosk.command({"reload"})));
    EXPECT_TRUE(eventually(
        [&] {
            const auto status = kiosk.status();
            return status.at("report").at("input") == kSmallRoom && status.at("shown") == "live";
        },
        milliseconds(5000 * kSlower)));
}

TEST_F(Control, BadRequestsAreAnsweredAndTheConnectionGoesOn) {
    const devices::UniqueFd socket = connection();
    for (const std::string bad : {"", "what", "{}", "{\"command\":1}", "[[[[", "\xFF\xFE"}) {
        const auto answer = nlohmann::json::parse(answerTo(socket, bad + "\n"));
        EXPECT_EQ(answer.at("ok"), false) << bad;
        EXPECT_TRUE(answer.at("error").get<std::string>().starts_with("request: ")) << bad;
    }
    const std::string status = "{\"command\":\"status\"}\n";
    EXPECT_TRUE(nlohmann::json::parse(answerTo(socket, status + status)).at("ok"));
    EXPECT_TRUE(nlohmann::json::parse(answerTo(socket, "")).at("ok")) << "one after the other";
}

TEST_F(Control, LinesThatAreTooLongAreRefusedAndTheConnectionEnds) {
    for (const std::size_t size : {std::size_t{5000}, std::size_t{1} << 20}) {
        const devices::UniqueFd socket = connection();
        const timeval patience{20, 0};
        (void)setsockopt(socket.get(), SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
        const auto answer = nlohmann::json::parse(answerTo(socket, std::string(size, ' ')));
        EXPECT_EQ(answer.at("error"), "request: longer than 4096 bytes");
        char more = 0;
        EXPECT_LE(::recv(socket.get(), &more, 1, 0), 0);
    }
    EXPECT_EQ(kiosk.status().at("shown"), "live");
}

// 100 at once, of which half say nothing, and one that takes no answer: pictures go on.
TEST_F(Control, ManyClientsAndSlowOnesHoldUpNobody) {
    std::vector<devices::UniqueFd> silent;
    silent.reserve(50);
    for (int i = 0; i < 50; ++i)
        silent.push_back(connection());
    const devices::UniqueFd deaf = connection();
    const std::string snapshot = "{\"command\":\"snapshot\"}\n";
    (void)::send(deaf.get(), snapshot.data(), snapshot.size(), MSG_NOSIGNAL);
    const std::uint64_t before = presented();
    std::atomic<int> answered{0};
    {
        std::vector<std::jthread> clients;
        clients.reserve(50);
        for (int i = 0; i < 50; ++i)
            clients.emplace_back([&] {
                try {
                    const devices::UniqueFd socket = connection();
                    const auto answer = daemon::ask(socket.get(), daemon::StatusRequest{});
                    if (answer.line.starts_with("{\"ok\":true")) ++answered;
                } catch (const std::exception&) { // counted below
                }
            });
    }
    EXPECT_EQ(answered, 50);
    EXPECT_TRUE(eventually([&] { return presented() > before + 3; }, milliseconds(5000 * kSlower)));
}

TEST_F(Control, OtherUsersAreRefused) {
    struct stat found {};
    ASSERT_EQ(::stat(kiosk.socket().c_str(), &found), 0);
    EXPECT_EQ(found.st_mode & 0777, 0660U);
    if (::geteuid() != 0) GTEST_SKIP() << "only root can be somebody else";
    std::filesystem::permissions(kiosk.folder() / "", std::filesystem::perms::all);
    std::filesystem::permissions(kiosk.socket(), std::filesystem::perms::all);
    auto call = calling({});
    const std::string program = call.program;
    call.program = "/usr/bin/setpriv";
    call.arguments = {"--reuid=65534", "--regid=65534", "--clear-groups", program,
                      "status",        "--socket",      kiosk.socket()};
    const ProgramResult refused = runProgram(call);
    EXPECT_TRUE(failedPlainly(refused, 2));
    EXPECT_NE(refused.err.find("not allowed"), std::string::npos);
}

TEST_F(Control, ASecondProgramLeavesTheFirstItsSocket) {
    auto second =
        calling({"run", "--config", kiosk.folder() / "kiosk.toml", "--display",
                 kiosk.folder() / "small.toml", "--output", "offscreen", "--frames", "2"});
    const ProgramResult result = runProgram(second);
    EXPECT_TRUE(succeeded(result));
    EXPECT_NE(result.err.find("another program answers there"), std::string::npos);
    EXPECT_EQ(kiosk.status().at("shown"), "live");
}

TEST(ControlCommands, WithoutAProgramNothingIsFound) {
    const TempFolder folder;
    EXPECT_TRUE(failedPlainly(runProgram(calling({"status", "--socket", folder / "none"})), 3));
    auto call = calling({"status"});
    call.environment.push_back("XDG_RUNTIME_DIR=" + folder / "");
    if (std::filesystem::exists("/run/autostereo")) GTEST_SKIP() << "one may run here";
    EXPECT_TRUE(failedPlainly(runProgram(call), 3));
}

TEST(ControlCommands, AStaleSocketIsReplaced) {
    Kiosk kiosk;
    kiosk.plugBoth();
    kiosk.start();
    kiosk.program().signal(SIGKILL);
    (void)kiosk.program().wait();
    ASSERT_TRUE(std::filesystem::exists(kiosk.socket()));
    kiosk.start();
    EXPECT_TRUE(succeeded(kiosk.stop()));
    EXPECT_FALSE(std::filesystem::exists(kiosk.socket())) << "and removed at the end";
}

TEST(ControlRecording, TheLastSecondsAreHandedOutWhileThePictureGoesOn) {
    Kiosk kiosk("[record]\nring_s = 2\n");
    kiosk.plugBoth();
    kiosk.start();
    ASSERT_TRUE(kiosk.shows("live", milliseconds(10'000)));
    std::this_thread::sleep_for(milliseconds(1000)); // so that there is something
    const auto presented = [&] {
        return kiosk.status().at("report").at("frames_presented").get<std::uint64_t>();
    };
    const std::uint64_t before = presented();
    const std::string file = kiosk.folder() / "last.mkv";
    ASSERT_TRUE(succeeded(kiosk.command({"snapshot", "--recording", file})));
    EXPECT_TRUE(eventually([&] { return presented() > before; }, milliseconds(2000 * kSlower)));
    EXPECT_TRUE(kiosk.shows("live", milliseconds(1000 * kSlower)));
    // What cannot be written is one line, and nobody else's trouble.
    EXPECT_TRUE(failedPlainly(kiosk.command({"snapshot", "--recording", "/nowhere/last.mkv"}), 1));
    ProgramCall full = calling({});
    const std::string spoilt = kiosk.folder() / "spoilt.mkv";
    full.arguments = {"-c",
                      "trap '' XFSZ; ulimit -f 10; exec \"$0\" \"$@\"",
                      full.program.string(),
                      "snapshot",
                      "--recording",
                      spoilt,
                      "--socket",
                      kiosk.socket()};
    full.program = "/bin/bash";
    EXPECT_TRUE(failedPlainly(runProgram(full), 1));
    EXPECT_FALSE(std::filesystem::exists(spoilt));
    EXPECT_TRUE(succeeded(kiosk.stop()));

    const std::string report = kiosk.folder() / "played.json";
    ASSERT_TRUE(succeeded(
        runProgram(calling({"run", "--input", file, "--display", smallDisplay(kiosk.folder()),
                            "--output", "offscreen", "--speed", "max", "--report", report}))));
    const RunReport played = readReport(report);
    EXPECT_TRUE(balanced(played));
    EXPECT_GT(played.accounts.framesIn, 0U);
    EXPECT_LE(played.accounts.depth.in, 61U); // two seconds
}

TEST_F(Control, NothingIsKeptUnlessItWasAskedFor) {
    const std::string file = kiosk.folder() / "last.mkv";
    const ProgramResult refused = kiosk.command({"snapshot", "--recording", file});
    EXPECT_TRUE(failedPlainly(refused, 1));
    EXPECT_NE(refused.err.find("ring_s is 0"), std::string::npos) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(file));
}

} // namespace
} // namespace autostereo::test
