#include "daemon/log.hpp"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>

namespace autostereo::daemon {

void setUpLog(const std::string& level) {
    auto logger = std::make_shared<spdlog::logger>(
        "autostereo", std::make_shared<spdlog::sinks::stderr_sink_mt>());
    logger->set_pattern("[%l] %v");
    logger->set_level(spdlog::level::from_str(level));
    spdlog::set_default_logger(std::move(logger));
}

} // namespace autostereo::daemon
