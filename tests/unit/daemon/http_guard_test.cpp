#include "daemon/http/http_guard.hpp"

#include "daemon/control/control_socket.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>

namespace autostereo::daemon {
namespace {

const std::string kSecret = "0123456789abcdef-_XYZ";

TEST(HttpGuard, OnlyItsOwnAddressesAreItsNames) {
    for (const char* host : {"127.0.0.1", "127.0.0.1:8787", "localhost", "LocalHost:99", "[::1]",
                             "[::1]:8787", "127.1.2.3:1"})
        EXPECT_TRUE(isOwnHost(host, true)) << host;
    for (const char* host : {"",
                             ":8787",
                             "evil.com",
                             "evil.com:8787",
                             "localhost.evil.com",
                             "127.0.0.1.evil.com",
                             "evil.com:127.0.0.1",
                             "127.0.0.1:8787:1",
                             "localhost@evil.com",
                             "192.168.0.1",
                             "0.0.0.0",
                             "[::1",
                             "::1",
                             "[::1]x",
                             "127.0.0.1:",
                             "127.0.0.1:x",
                             "127.0.0.1 ",
                             "2130706433",
                             "[",
                             "]",
                             "[]"})
        EXPECT_FALSE(isOwnHost(host, true)) << host;
    EXPECT_TRUE(isOwnHost("192.168.0.1:8787", false));
    EXPECT_TRUE(isOwnHost("localhost", false));
    EXPECT_FALSE(isOwnHost("kiosk.museum", false)) << "a name server's word";
}

TEST(HttpGuard, OnlyItsOwnPageIsItsOrigin) {
    EXPECT_TRUE(isOwnOrigin("http://127.0.0.1:8787", "127.0.0.1:8787"));
    EXPECT_TRUE(isOwnOrigin("http://LOCALHOST:8787", "localhost:8787"));
    for (const char* origin :
         {"", "null", "http://evil.com", "http://127.0.0.1", "http://127.0.0.1:80",
          "http://127.0.0.1:87871", "https://127.0.0.1:8787", "http://127.0.0.1:8787/"})
        EXPECT_FALSE(isOwnOrigin(origin, "127.0.0.1:8787")) << origin;
}

TEST(HttpToken, OpensForItselfAlone) {
    const test::ScratchFolder folder;
    const auto file = folder.write("token", kSecret + "\n");
    ::chmod(file.c_str(), 0640);
    const HttpToken token(file);
    EXPECT_TRUE(token.exists());
    EXPECT_TRUE(token.opens("Bearer " + kSecret));
    std::string twice = "Bearer " + kSecret;
    twice += kSecret;
    for (const std::string& wrong :
         {std::string(), std::string("Bearer "), kSecret, "bearer " + kSecret,
          "Bearer " + kSecret + " ", "Bearer " + kSecret.substr(1),
          "Bearer " + kSecret.substr(0, kSecret.size() - 1), twice,
          "Bearer " + std::string(kSecret.size(), 'x'), "Basic " + kSecret})
        EXPECT_FALSE(token.opens(wrong)) << wrong;
    std::string almost = "Bearer " + kSecret;
    for (std::size_t i = 7; i < almost.size(); ++i) {
        std::string wrong = almost;
        wrong[i] = '*';
        EXPECT_FALSE(token.opens(wrong)) << i;
    }
    EXPECT_FALSE(HttpToken().exists());
    EXPECT_FALSE(HttpToken().opens("Bearer "));
}

TEST(HttpToken, IsDrawnWhereThereIsNone) {
    const test::ScratchFolder folder;
    const HttpToken first(folder / "a"), second(folder / "b");
    std::string text;
    std::ifstream(folder / "a") >> text;
    EXPECT_EQ(text.size(), 64U);
    EXPECT_TRUE(first.opens("Bearer " + text));
    EXPECT_FALSE(second.opens("Bearer " + text));
    EXPECT_TRUE(HttpToken(folder / "a").opens("Bearer " + text)) << "it stays";
    struct stat found {};
    ASSERT_EQ(::stat((folder / "a").c_str(), &found), 0);
    EXPECT_EQ(found.st_mode & 0777, 0600U);
}

TEST(HttpToken, FilesThatAreNoneAreRefusedInOneLine) {
    const test::ScratchFolder folder;
    const auto problemOf = [&](const std::filesystem::path& file) -> std::string {
        try {
            const HttpToken token(file);
        } catch (const ControlError& error) {
            return error.what();
        }
        return "none";
    };
    const auto with = [&](const std::string& text) {
        const auto file = folder.write("token", text);
        ::chmod(file.c_str(), 0600);
        return problemOf(file);
    };
    for (const std::string& text :
         {std::string(), std::string("short"), std::string(257, 'a'), std::string(9999, 'a'),
          std::string("two words of a token"), std::string("0123456789abcdef\n0123456789abcdef"),
          std::string(20, '\0')}) {
        const std::string problem = with(text);
        EXPECT_NE(problem.find("it holds no token"), std::string::npos) << problem;
        EXPECT_EQ(problem.find('\n'), std::string::npos);
    }
    ASSERT_EQ(with(kSecret), "none");
    ::chmod((folder / "token").c_str(), 0644);
    EXPECT_NE(problemOf(folder / "token").find("everybody may read it"), std::string::npos);
    EXPECT_NE(problemOf(folder.path()).find("it is no file"), std::string::npos);
    EXPECT_NE(problemOf(folder / "none/token").find("No such file"), std::string::npos);
}

} // namespace
} // namespace autostereo::daemon
