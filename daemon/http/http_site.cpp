#include "daemon/http/http_site.hpp"

#include "daemon/embedded_files.hpp"
#include "daemon/http/http_picture.hpp"

#include <nlohmann/json.hpp>

#include <charconv>
#include <cmath>
#include <limits>

namespace autostereo::daemon {

namespace {

constexpr const char* kJson = "application/json";
constexpr double kPicturesPerSecond = 10; // of all clients together: each costs a frame some time
constexpr int kPreviewSide = 640;         // pixels

void refuse(httplib::Response& response, int status, const std::string& why) {
    response.status = status;
    response.set_content(refusal(why, kBadRequest).line, kJson);
}

/// What happened to a request that the program itself answered.
int statusOf(const ControlReply& reply) {
    if (!reply.line.starts_with('{')) return 200; // metrics
    const auto line = nlohmann::json::parse(reply.line, nullptr, false);
    if (line.is_object() && line.value("ok", false)) return 200;
    const int code = line.is_object() ? line.value("code", 0) : 0;
    if (code == kNotNow) return 429;
    return code == kBadRequest ? 400 : 503;
}

/// As many bytes as a request says that its body has; none where it does not say so plainly.
std::optional<std::size_t> bodySize(const httplib::Request& request) {
    const std::size_t times = request.get_header_value_count("Content-Length");
    if (times == 0) return 0;
    const std::string text = request.get_header_value("Content-Length");
    std::size_t size = 0;
    const char* end = text.data() + text.size();
    const auto [stopped, problem] = std::from_chars(text.data(), end, size);
    if (times > 1 || text.empty() || stopped != end) return std::nullopt;
    return problem == std::errc() ? size : std::numeric_limits<std::size_t>::max();
}

std::optional<double> placeOf(const std::string& text) {
    double place = 0;
    const char* end = text.data() + text.size();
    const auto [stopped, problem] = std::from_chars(text.data(), end, place);
    if (problem != std::errc() || stopped != end || !(std::abs(place) <= 1)) return std::nullopt;
    return place;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

} // namespace

HttpSite::HttpSite(bool loopback, HttpToken token, QuestionBox& box, HttpRefusals& refusals,
                   const HttpLimits& limits)
    : loopback_(loopback), token_(std::move(token)), box_(box), refusals_(refusals),
      limits_(limits), pictures_(kPicturesPerSecond) {
    set_payload_max_length(limits.body);
    set_default_headers({{"Cache-Control", "no-store"},
                         {"X-Content-Type-Options", "nosniff"},
                         {"Referrer-Policy", "no-referrer"},
                         {"Cross-Origin-Resource-Policy", "same-origin"},
                         {"X-Frame-Options", "DENY"}});
    set_pre_routing_handler([this](const Request& request, Response& response) {
        return admits(request, response) ? HandlerResponse::Unhandled : HandlerResponse::Handled;
    });
    set_exception_handler([](const Request&, Response& response, std::exception_ptr problem) {
        try {
            std::rethrow_exception(std::move(problem));
        } catch (const std::exception& error) {
            refuse(response, 500, error.what());
        }
    });
    set_error_handler([](const Request& /*request*/, Response& response) {
        if (response.body.empty())
            refuse(response, response.status, "http: nothing here answers such a request");
    });
    set_logger([this](const Request& /*request*/, const Response& response) {
        refusals_.note(response.status);
    });
    addRoutes();
}

void HttpSite::addRoutes() {
    Get("/", [this](const Request&, Response& response) { page(response); });
    Get("/status", [this](const Request&, Response& response) {
        text(ControlRequest(StatusRequest{}), kJson, response);
    });
    Get("/metrics", [this](const Request&, Response& response) {
        text(MetricsRequest{}, "text/plain; version=0.0.4; charset=utf-8", response);
    });
    using Of = PreviewRequest::Of;
    for (const auto& [path, of] : {std::pair{"/preview/color.png", Of::Color},
                                   {"/preview/depth.png", Of::Depth},
                                   {"/preview/eye.png", Of::Eye}})
        Get(path, [this, of = of](const Request& request, Response& response) {
            preview(request, {of, 0}, response);
        });
    Post("/control",
         [this](const Request& request, Response& response) { control(request, response); });
}

void HttpSite::serve(int socket) {
    HttpStream stream(socket, limits_);
    switch (stream.readHead()) {
    case HttpStream::Head::Whole: {
        bool closed = false;
        process_request(stream, true, closed, {});
        break;
    }
    case HttpStream::Head::TooLarge:
        turnAway(stream, 431, "Request Header Fields Too Large");
        break;
    case HttpStream::Head::Late:
        turnAway(stream, 408, "Request Timeout");
        break;
    case HttpStream::Head::Gone:
        return;
    }
    stream.end();
}

void HttpSite::turnAway(HttpStream& stream, int status, const char* reason) {
    stream.write("HTTP/1.1 " + std::to_string(status) + ' ' + reason +
                 "\r\nConnection: close\r\nContent-Length: 0\r\n\r\n");
    refusals_.note(status);
}

bool HttpSite::admits(const Request& request, Response& response) const {
    const std::string host = request.get_header_value("Host");
    const auto no = [&](int status, const std::string& why) {
        refuse(response, status, why);
        return false;
    };
    if (request.get_header_value_count("Host") != 1 || !isOwnHost(host, loopback_))
        return no(403, "http: this is no name of mine (allowed: my address in digits, localhost)");
    if (request.has_header("Origin") && (request.get_header_value_count("Origin") != 1 ||
                                         !isOwnOrigin(request.get_header_value("Origin"), host)))
        return no(403, "http: a page from elsewhere asks");
    if (request.has_header("Transfer-Encoding"))
        return no(411, "http: a body needs its Content-Length");
    if (request.has_header("Content-Encoding")) return no(415, "http: a body comes as it is");
    const auto body = bodySize(request);
    if (!body) return no(400, "http: Content-Length is no number");
    if (*body > limits_.body)
        return no(413, "http: the body is longer than " + std::to_string(limits_.body) + " bytes");
    // A form of a foreign page sends other types without asking; those are not even taken apart.
    if (request.method != "GET" && request.method != "HEAD" &&
        request.get_header_value("Content-Type") != kJson)
        return no(415, "http: Content-Type has to be application/json");
    const bool open = request.path != "/control" && !request.path.starts_with("/preview/");
    return open || opensFor(request, response);
}

bool HttpSite::opensFor(const Request& request, Response& response) const {
    if (!token_.exists()) {
        refuse(response, 403, "http: no pictures, no controls: http.token_file is not configured");
        return false;
    }
    if (request.get_header_value_count("Authorization") == 1 &&
        token_.opens(request.get_header_value("Authorization")))
        return true;
    refuse(response, 401, "http: needs the token of http.token_file (Authorization: Bearer TOKEN)");
    response.set_header("WWW-Authenticate", "Bearer");
    return false;
}

std::optional<ControlReply> HttpSite::ask(const Question& question, Response& response) {
    auto reply = box_.ask(question, limits_.answer);
    if (!reply)
        refuse(response, 503, "http: the program does not answer");
    else if (const int status = statusOf(*reply); status != 200) {
        response.status = status;
        if (status == 429) response.set_header("Retry-After", "1");
        response.set_content(reply->line, kJson);
        return std::nullopt;
    }
    return reply;
}

void HttpSite::text(const Question& question, const char* type, Response& response) {
    if (const auto reply = ask(question, response)) response.set_content(reply->line, type);
}

void HttpSite::picture(const Question& question, int longest, Response& response) {
    if (!pictures_.pass(devices::SteadyClock().now())) {
        refuse(response, 429, "http: too many pictures a second");
        response.set_header("Retry-After", "1");
        return;
    }
    if (auto reply = ask(question, response))
        response.set_content(pngOf(shrunk(pictureIn(*reply), longest)), "image/png");
}

void HttpSite::preview(const Request& request, PreviewRequest wish, Response& response) {
    if (wish.of == PreviewRequest::Of::Eye && request.has_param("x")) {
        const auto place = placeOf(request.get_param_value("x"));
        if (!place)
            return refuse(response, 400, "http: x is no place on the fan (allowed -1 to 1)");
        wish.eye = *place;
    }
    picture(wish, kPreviewSide, response);
}

void HttpSite::control(const Request& request, Response& response) {
    try {
        const ControlRequest wish = parseRequest(request.body);
        if (std::holds_alternative<RecordingRequest>(wish))
            refuse(response, 400, "http: recordings are handed out over the control socket only");
        else if (std::holds_alternative<SnapshotRequest>(wish))
            picture(wish, std::numeric_limits<int>::max(), response);
        else
            text(wish, kJson, response);
    } catch (const RequestError& error) {
        refuse(response, 400, error.what());
    }
}

void HttpSite::page(Response& response) const {
    const std::string nonce = randomWord(16);
    response.set_header("Content-Security-Policy",
                        "default-src 'none'; connect-src 'self'; img-src blob: data:; script-src "
                        "'nonce-" +
                            nonce + "'; style-src 'nonce-" + nonce +
                            "'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'");
    response.set_content(replaced(std::string(embeddedFiles().front().text), "@NONCE@", nonce),
                         "text/html; charset=utf-8");
}

} // namespace autostereo::daemon
