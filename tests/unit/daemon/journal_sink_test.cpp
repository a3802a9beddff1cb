#include "daemon/journal_sink.hpp"

#include "devices/unique_fd.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <array>
#include <string>

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

namespace autostereo::daemon {
namespace {

/// What stands in for the journal.
class Journal {
  public:
    Journal() : fd_(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
        sockaddr_un place{};
        place.sun_family = AF_UNIX;
        std::ranges::copy(path(), place.sun_path);
        EXPECT_EQ(::bind(fd_.get(), reinterpret_cast<const sockaddr*>(&place), sizeof place), 0);
    }
    [[nodiscard]] std::string path() const { return folder_ / "socket"; }
    /// The next datagram; "": there is none.
    [[nodiscard]] std::string hear() const {
        std::array<char, 4096> bytes{};
        const auto size = ::recv(fd_.get(), bytes.data(), bytes.size(), 0);
        return {bytes.data(), size > 0 ? static_cast<std::size_t>(size) : 0};
    }

  private:
    test::ScratchFolder folder_;
    devices::UniqueFd fd_;
};

/// Without the one field that changes from run to run.
std::string withoutThread(std::string datagram) {
    const std::size_t at = datagram.find("TID=");
    EXPECT_NE(at, std::string::npos);
    return datagram.erase(at, datagram.find('\n', at) + 1 - at);
}

TEST(JournalSink, AMessageCarriesItsFields) {
    const Journal journal;
    spdlog::logger log("test", journalSink(journal.path()));
    log.set_level(spdlog::level::trace);
    log.info("panel: live after 1.5 s of idle");
    EXPECT_EQ(withoutThread(journal.hear()),
              "MESSAGE=panel: live after 1.5 s of idle\nPRIORITY=6\n"
              "SYSLOG_IDENTIFIER=autostereo\nAUTOSTEREO_PART=panel\n");
    log.warn("Nothing in particular");
    EXPECT_EQ(withoutThread(journal.hear()),
              "MESSAGE=Nothing in particular\nPRIORITY=4\nSYSLOG_IDENTIFIER=autostereo\n");
    log.error("cannot open a file: no such file");
    EXPECT_EQ(journal.hear().find("AUTOSTEREO_PART"), std::string::npos) << "several words";
    log.debug("x");
    EXPECT_NE(journal.hear().find("PRIORITY=7\n"), std::string::npos);
    EXPECT_EQ(journal.hear(), "");
}

TEST(JournalSink, SeveralLinesForgeNoField) {
    const Journal journal;
    spdlog::logger log("test", journalSink(journal.path()));
    log.info("a\nPRIORITY=0");
    const std::string length("\x0c\0\0\0\0\0\0\0", 8);
    EXPECT_EQ(withoutThread(journal.hear()), "MESSAGE\n" + length +
                                                 "a\nPRIORITY=0\nPRIORITY=6\n"
                                                 "SYSLOG_IDENTIFIER=autostereo\n");
}

TEST(JournalSink, WhatTheJournalDoesNotTakeIsOnStderr) {
    const test::ScratchFolder folder;
    spdlog::logger log("test", journalSink(folder / "nobody"));
    log.set_pattern("[%l] %v");
    testing::internal::CaptureStderr();
    log.warn("tof: sensor lost");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "[warning] tof: sensor lost\n");
}

TEST(JournalSink, OnlyTheJournalsOwnStreamIsTheJournal) {
    const Journal journal;
    std::array<int, 2> ends{};
    ASSERT_EQ(::pipe(ends.data()), 0);
    const devices::UniqueFd out(ends[0]), in(ends[1]);
    struct stat is {};
    ASSERT_EQ(::fstat(in.get(), &is), 0);
    const std::string own = std::to_string(is.st_dev) + ':' + std::to_string(is.st_ino);
    EXPECT_TRUE(isJournal(own.c_str(), in.get()));
    EXPECT_FALSE(isJournal((own + '0').c_str(), in.get())); // another inode: redirected since
    EXPECT_FALSE(isJournal(nullptr, in.get()));
    for (const char* nonsense : {"", "12", "a:b", ":"})
        EXPECT_FALSE(isJournal(nonsense, in.get())) << nonsense;
}

} // namespace
} // namespace autostereo::daemon
