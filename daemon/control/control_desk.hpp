#pragma once

#include "daemon/command_line.hpp"
#include "daemon/control/control_server.hpp"
#include "daemon/control/time_share.hpp"
#include "daemon/http/http_server.hpp"
#include "daemon/session/session.hpp"

#include <future>
#include <memory>

namespace autostereo::daemon {

/// The operator's wishes, from control socket and page to the session. Thread-bound.
class ControlDesk {
  public:
    /// A socket that cannot be opened is warned of: the picture is worth more. Throws ControlError
    /// for a group that is not there. So for the page's address; its token file has to be good.
    ControlDesk(const RunOptions& options, const config::Config& config, Session& session);

    /// Answers who asked, a few at a time. Never waits.
    void serve();
    /// Reads the configuration again; what is wrong with it goes to the log, and nothing changes.
    void reload();

  private:
    void openPage();
    void hand(const ControlServer::Asked& asked);
    void handRecording(std::uint64_t client);
    [[nodiscard]] ControlReply answer(const Question& question);
    [[nodiscard]] ControlReply answerTo(const ControlRequest& request);
    [[nodiscard]] ControlReply answerTo(const MetricsRequest& request);
    [[nodiscard]] ControlReply answerTo(const PreviewRequest& request);
    [[nodiscard]] ControlReply answerTo(const StatusRequest& request);
    [[nodiscard]] ControlReply answerTo(const SnapshotRequest& request);
    [[nodiscard]] ControlReply answerTo(const RecordingRequest& request);
    [[nodiscard]] ControlReply answerTo(const ReloadRequest& request);
    [[nodiscard]] ControlReply answerTo(const SetRequest& request);
    [[nodiscard]] ControlReply answerTo(const ShowRequest& request);
    /// The session's, and the page's.
    [[nodiscard]] Status status();
    void replaceConfiguration();

    SceneOptions options_;
    config::Config config_;
    Session& session_;
    TimeShare previews_{4};                 ///< a fifth of the time at most
    std::unique_ptr<ControlServer> server_; ///< none: no socket
    std::uint64_t recordingFor_ = 0;        ///< whom the next is for
    std::future<ControlReply> recording_;   ///< being put together on a thread of its own
    std::unique_ptr<HttpServer> page_;      ///< none: no page
};

} // namespace autostereo::daemon
