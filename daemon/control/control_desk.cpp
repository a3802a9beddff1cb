#include "daemon/control/control_desk.hpp"

#include "config/load.hpp"
#include "daemon/control/control_socket.hpp"
#include "daemon/log.hpp"
#include "daemon/session/metrics.hpp"
#include "daemon/session/pattern_picture.hpp"

#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include <chrono>
#include <utility>

namespace autostereo::daemon {

namespace {

constexpr int kMostAtOnce = 8; // answered between two pictures
constexpr int kMostOfPage = 2;
constexpr int kFailed = 1;

ControlReply done() { return {R"({"ok": true})"}; }

ControlReply pictureReply(gpu::RgbImage image) {
    const nlohmann::ordered_json line{{"ok", true},
                                      {"width", image.width},
                                      {"height", image.height},
                                      {"bytes", image.pixels.size()}};
    return {line.dump(),
            std::make_shared<const std::vector<std::uint8_t>>(std::move(image.pixels))};
}

ControlReply recordingReply(const devices::RecordingRing::Held& held) try {
    auto bytes = std::make_shared<const std::vector<std::uint8_t>>(devices::recordingOf(held));
    const nlohmann::ordered_json line{
        {"ok", true}, {"pictures", held.pictures.size()}, {"bytes", bytes->size()}};
    return {line.dump(), std::move(bytes)};
} catch (const std::exception& error) {
    return refusal(error.what(), kFailed);
}

std::optional<std::filesystem::path> socketOf(const config::ControlParams& params) {
    if (!params.socket) return ownControlSocket();
    if (params.socket->empty()) return std::nullopt;
    return *params.socket;
}

} // namespace

ControlDesk::ControlDesk(const RunOptions& options, const config::Config& config, Session& session)
    : options_(options.scene), config_(config), session_(session) {
    std::optional<gid_t> group;
    if (!config.control.group.empty()) group = groupNamed(config.control.group);
    if (config.http.listen) openPage();
    const auto socket = socketOf(config.control);
    if (!socket) return;
    try {
        server_ = std::make_unique<ControlServer>(*socket, group);
        spdlog::info("control: {}", socket->string());
    } catch (const ControlError& error) {
        spdlog::warn("{}", error.what());
    }
}

void ControlDesk::openPage() try {
    page_ = std::make_unique<HttpServer>(config_.http);
    spdlog::info("http: {}", page_->address());
} catch (const ControlError& error) {
    spdlog::warn("{}", error.what());
}

void ControlDesk::serve() {
    for (int i = 0; server_ && i < kMostAtOnce; ++i) {
        const auto asked = server_->take();
        if (!asked) break;
        hand(*asked);
    }
    if (recording_.valid() &&
        recording_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)
        server_->answer(recordingFor_, recording_.get());
    for (int i = 0; page_ && i < kMostOfPage; ++i) {
        const auto question = page_->take();
        if (!question) break;
        page_->answer(answer(*question));
    }
}

void ControlDesk::hand(const ControlServer::Asked& asked) {
    if (std::holds_alternative<RecordingRequest>(asked.request))
        handRecording(asked.client);
    else
        server_->answer(asked.client, answer(asked.request));
}

void ControlDesk::handRecording(std::uint64_t client) {
    auto last = session_.lastPictures();
    if (recording_.valid())
        return server_->answer(client,
                               refusal("recording: another one is being handed out", kNotNow));
    if (!last)
        return server_->answer(
            client, refusal("recording: nothing is kept ([record] ring_s is 0)", kFailed));
    if (last->pictures.empty())
        return server_->answer(client, refusal("recording: no pictures came lately", kFailed));
    recordingFor_ = client;
    recording_ =
        std::async(std::launch::async, [held = std::move(*last)] { return recordingReply(held); });
}

ControlReply ControlDesk::answer(const Question& question) try {
    return std::visit([this](const auto& wish) { return answerTo(wish); }, question);
} catch (const config::ConfigError& error) {
    return refusal(error.what(), kBadRequest);
} catch (const devices::AddressError& error) {
    return refusal(error.what(), kBadRequest);
} catch (const UsageError& error) {
    return refusal(error.what(), kBadRequest);
} catch (const std::exception& error) {
    return refusal(error.what(), kFailed);
}

ControlReply ControlDesk::answerTo(const ControlRequest& request) {
    return std::visit([this](const auto& wish) { return answerTo(wish); }, request);
}

Status ControlDesk::status() {
    Status status = session_.status();
    if (page_) status.httpRefused = page_->refusals();
    return status;
}

ControlReply ControlDesk::answerTo(const MetricsRequest& /*request*/) {
    return {metricsText(status(), session_.accounts(), residentMemory())};
}

ControlReply ControlDesk::answerTo(const PreviewRequest& request) {
    const devices::SteadyClock clock;
    const devices::TimePoint start = clock.now();
    if (!previews_.isFree(start)) return refusal("preview: the panel comes first", kNotNow);
    ControlReply reply = pictureReply(session_.preview(request));
    previews_.used(start, clock.now());
    return reply;
}

ControlReply ControlDesk::answerTo(const StatusRequest& /*request*/) {
    return {statusLine(status(), session_.accounts())};
}

ControlReply ControlDesk::answerTo(const SnapshotRequest& /*request*/) {
    return pictureReply(session_.picture());
}

ControlReply ControlDesk::answerTo(const RecordingRequest& /*request*/) {
    return refusal("recording: only over the control socket", kBadRequest);
}

ControlReply ControlDesk::answerTo(const ReloadRequest& /*request*/) {
    try {
        replaceConfiguration();
    } catch (const std::exception& error) {
        spdlog::warn("reload: the old configuration stays: {}", error.what());
        throw;
    }
    return done();
}

ControlReply ControlDesk::answerTo(const SetRequest& request) {
    config::Config next = config::changed(config_, request.name, request.value);
    session_.adjust(next);
    config_ = std::move(next);
    spdlog::info("set: {} = {}", request.name, request.value);
    return done();
}

ControlReply ControlDesk::answerTo(const ShowRequest& request) {
    if (request.what == "live")
        session_.showPattern(std::nullopt);
    else
        session_.showPattern(patternNamed(request.what));
    spdlog::info("show: {}", request.what);
    return done();
}

void ControlDesk::reload() {
    const ControlReply reply = answer(ControlRequest(ReloadRequest{}));
    static_cast<void>(reply); // nobody asked on a socket; the log has it
}

void ControlDesk::replaceConfiguration() {
    config::Config next = configuration(options_);
    session_.replace(next);
    if (next.control.socket != config_.control.socket ||
        next.control.group != config_.control.group)
        spdlog::warn("reload: [control] needs a restart");
    if (!(next.http == config_.http)) spdlog::warn("reload: [http] needs a restart");
    config_ = std::move(next);
    setUpLog(config_.log.level);
    spdlog::info("reload: done");
}

} // namespace autostereo::daemon
