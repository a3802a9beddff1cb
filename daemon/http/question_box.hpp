#pragma once

#include "daemon/control/control_server.hpp"

#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <variant>

namespace autostereo::daemon {

/// Every figure, as Prometheus reads it: the answer's line.
struct MetricsRequest {};
/// A small picture of what is live: the answer is that of a snapshot.
struct PreviewRequest {
    enum class Of {
        Color, ///< the colour camera's picture, its own size
        Depth, ///< disparity, near bright, far dark
        Eye    ///< what an eye there sees
    };
    Of of = Of::Color;
    double eye = 0; ///< place on the fan, -1 (its left edge) to 1
};
/// What a question is answered with that may be asked again a little later.
inline constexpr int kNotNow = 75; // EX_TEMPFAIL
using Question = std::variant<ControlRequest, MetricsRequest, PreviewRequest>;

/// Questions of other threads to the one that owns the session, who answers between two pictures.
class QuestionBox {
  public:
    /// Waits for the answer; none where that takes longer than `limit`, or the box is closed.
    /// Thread-safe.
    [[nodiscard]] std::optional<ControlReply> ask(Question question,
                                                  std::chrono::milliseconds limit);
    /// Nobody waits from now on. Thread-safe.
    void close();

    /// One that somebody still waits for, if any; never waits itself. `answer` is for that one.
    /// Both belong to the session's thread.
    [[nodiscard]] std::optional<Question> take();
    void answer(ControlReply reply);

  private:
    struct Asked {
        Question question;
        std::optional<ControlReply> reply;
    };
    std::mutex mutex_; ///< of all of it
    std::condition_variable answered_;
    std::deque<std::shared_ptr<Asked>> waiting_;
    std::shared_ptr<Asked> taken_;
    bool closed_ = false;
};

} // namespace autostereo::daemon
