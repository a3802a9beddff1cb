#include "daemon/log.hpp"

#include "daemon/journal_sink.hpp"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <cstdlib>
#include <memory>
#include <utility>

#include <unistd.h>

namespace autostereo::daemon {

void setUpLog(const std::string& level) {
    spdlog::sink_ptr sink = isJournal(std::getenv("JOURNAL_STREAM"), STDERR_FILENO)
                                ? journalSink()
                                : std::make_shared<spdlog::sinks::stderr_sink_mt>();
    auto logger = std::make_shared<spdlog::logger>("autostereo", std::move(sink));
    logger->set_pattern("[%l] %v");
    logger->set_level(spdlog::level::from_str(level));
    spdlog::set_default_logger(std::move(logger));
}

} // namespace autostereo::daemon
