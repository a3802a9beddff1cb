#pragma once

#include "daemon/http/http_guard.hpp"
#include "daemon/http/http_refusals.hpp"
#include "daemon/http/http_stream.hpp"
#include "daemon/http/question_box.hpp"
#include "daemon/http/rate_limit.hpp"

#include <httplib.h>

#include <memory>
#include <string>

namespace autostereo::daemon {

/// What is asked and told over HTTP, and by whom: GET / (the operator's page), /status, /metrics,
/// /preview/color.png, depth.png, eye.png?x=, and POST /control. Foreign Host and Origin are
/// refused; pictures and controls need the token. Nothing is recorded this way. Each request is a
/// connection of its own. Questions go through the box; everything else is done on the connection's
/// own thread. Reentrant once constructed.
class HttpSite : private httplib::Server {
  public:
    /// `box` and `refusals`, which counts them, must outlive it. `loopback`: it listens where only
    /// this machine can reach it.
    HttpSite(bool loopback, HttpToken token, QuestionBox& box, HttpRefusals& refusals,
             const HttpLimits& limits);

    /// One connection: a request, its reply. Does not close the socket.
    void serve(int socket);

  private:
    using Request = httplib::Request;
    using Response = httplib::Response;

    void addRoutes();
    void turnAway(HttpStream& stream, int status, const char* reason);
    /// Whether the request may go on; else the response says why not.
    [[nodiscard]] bool admits(const Request& request, Response& response) const;
    [[nodiscard]] bool opensFor(const Request& request, Response& response) const;
    void page(Response& response) const;
    void text(const Question& question, const char* type, Response& response);
    void preview(const Request& request, PreviewRequest wish, Response& response);
    void control(const Request& request, Response& response);
    void picture(const Question& question, int longest, Response& response);
    /// None where the response says why.
    [[nodiscard]] std::optional<ControlReply> ask(const Question& question, Response& response);

    bool loopback_;
    HttpToken token_;
    QuestionBox& box_;
    HttpRefusals& refusals_;
    HttpLimits limits_;
    RateLimit pictures_;
};

} // namespace autostereo::daemon
