#pragma once

#include "config/config.hpp"
#include "daemon/http/http_limits.hpp"
#include "daemon/http/http_refusals.hpp"
#include "daemon/http/question_box.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace autostereo::daemon {

class HttpListener;
class HttpSite;

/// The HTTP side of a running program: threads that never make it wait. `take` and `answer` belong
/// to the thread that constructs it.
class HttpServer {
  public:
    /// Listens. `params.listen` has to be there. Throws ControlError.
    explicit HttpServer(const config::HttpParams& params, const HttpLimits& limits = {});
    ~HttpServer();
    HttpServer(const HttpServer&) = delete;
    HttpServer& operator=(const HttpServer&) = delete;

    /// "http://127.0.0.1:8787/"
    [[nodiscard]] std::string address() const;
    [[nodiscard]] std::uint16_t port() const;

    /// A question that waits for its answer, if any; never waits itself.
    [[nodiscard]] std::optional<Question> take() { return box_.take(); }
    void answer(ControlReply reply) { box_.answer(std::move(reply)); }

    /// Since it listens, by status. Thread-safe.
    [[nodiscard]] HttpRefusals::Counts refusals() const { return refusals_.counts(); }

  private:
    config::ListenAddress listen_;
    QuestionBox box_;
    HttpRefusals refusals_;
    std::unique_ptr<HttpSite> site_;
    std::unique_ptr<HttpListener> listener_; // last: its threads use all of the above
};

} // namespace autostereo::daemon
