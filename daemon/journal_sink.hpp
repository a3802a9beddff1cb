#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace spdlog::sinks {
class sink;
} // namespace spdlog::sinks

namespace autostereo::daemon {

inline constexpr const char* kJournalSocket = "/run/systemd/journal/socket";

/// Whether the descriptor is the journal's own stream: `journalStream` is $JOURNAL_STREAM, device
/// and inode as systemd.exec(5) has it; null: no. Reentrant.
[[nodiscard]] bool isJournal(const char* journalStream, int descriptor);

/// Sends messages with their fields in the journal's native protocol: MESSAGE, PRIORITY (syslog's),
/// SYSLOG_IDENTIFIER, TID, and AUTOSTEREO_PART, what the message is about ("panel: live ...":
/// panel). Never waits: what the journal does not take goes to stderr as a line. Thread-safe.
[[nodiscard]] std::shared_ptr<spdlog::sinks::sink>
journalSink(const std::filesystem::path& socket = kJournalSocket);

} // namespace autostereo::daemon
