#include "daemon/http/http_server.hpp"

#include "daemon/control/control_socket.hpp"
#include "devices/replay/png_decoder.hpp"
#include "tests/support/http_talk.hpp"
#include "tests/support/scratch_folder.hpp"

#include <gtest/gtest.h>
#include <httplib.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <random>
#include <span>
#include <thread>

namespace autostereo::daemon {
namespace {

using std::chrono::milliseconds;
using test::answerTo;
using test::statusOf;

const std::string kToken = "0123456789abcdef0123456789abcdef";

/// A server, and a program behind it that answers what it was asked.
class HttpServing : public testing::Test {
  protected:
    void SetUp() override {
        (void)folder_.write("token", kToken);
        std::filesystem::permissions(folder_ / "token", std::filesystem::perms::owner_all);
        limits.request = milliseconds(30'000);
        start();
    }
    void TearDown() override { stop(); }

    void start(const std::string& tokenFile = "token") {
        stop();
        config::HttpParams params{config::ListenAddress{"127.0.0.1", 0, true}, ""};
        if (!tokenFile.empty()) params.tokenFile = folder_ / tokenFile;
        server = std::make_unique<HttpServer>(params, limits);
        ended_ = false;
        program_ = std::thread([this] { answerAll(); });
    }
    void stop() {
        ended_ = true;
        if (program_.joinable()) program_.join();
        server.reset();
    }
    [[nodiscard]] httplib::Client client() const {
        httplib::Client client("127.0.0.1", server->port());
        client.set_read_timeout(30);
        return client;
    }
    [[nodiscard]] std::string host() const {
        return "Host: 127.0.0.1:" + std::to_string(server->port()) + "\r\n";
    }
    /// GET with more header lines.
    [[nodiscard]] int get(const std::string& path, const std::string& headers) const {
        return statusOf(
            answerTo(server->port(), "GET " + path + " HTTP/1.1\r\n" + headers + "\r\n"));
    }
    static inline const httplib::Headers kAuthorized{{"Authorization", "Bearer " + kToken}};

    HttpLimits limits;
    std::unique_ptr<HttpServer> server;
    std::atomic<int> told{0}; ///< that something be changed
    std::atomic<bool> asleep{false};

  private:
    void answerAll() {
        while (!ended_) {
            if (const auto question = asleep ? std::nullopt : server->take())
                server->answer(answer(*question));
            else
                std::this_thread::sleep_for(milliseconds(1));
        }
    }
    ControlReply answer(const Question& question) {
        if (std::holds_alternative<MetricsRequest>(question)) return {"metrics 1\n"};
        if (const auto* wish = std::get_if<PreviewRequest>(&question)) {
            if (wish->of == PreviewRequest::Of::Depth) return refusal("nothing is shown", 1);
            // As large as a camera's; its shade says what was asked for.
            const auto shade = static_cast<std::uint8_t>(100 + 100 * wish->eye);
            return {R"({"ok":true,"width":1280,"height":720})",
                    std::make_shared<const std::vector<std::uint8_t>>(3 * 1280 * 720, shade)};
        }
        const auto& request = std::get<ControlRequest>(question);
        if (std::holds_alternative<StatusRequest>(request)) return {R"({"ok":true,"shown":"x"})"};
        ++told;
        const auto* set = std::get_if<SetRequest>(&request);
        if (set != nullptr && set->name == "colour") return refusal("set: colour", kBadRequest);
        return {requestLine(request).replace(0, 1, R"({"ok":true,)")};
    }

    test::ScratchFolder folder_;
    std::atomic<bool> ended_{false};
    std::thread program_;
};

TEST_F(HttpServing, PageFiguresAndMetricsAreForWhoeverGetsThrough) {
    auto http = client();
    const auto page = http.Get("/");
    ASSERT_TRUE(page);
    EXPECT_EQ(page->get_header_value("Content-Type"), "text/html; charset=utf-8");
    const std::string policy = page->get_header_value("Content-Security-Policy");
    EXPECT_TRUE(policy.starts_with("default-src 'none'; ")) << policy;
    const std::string nonce = policy.substr(policy.find("'nonce-") + 7, 32);
    EXPECT_NE(page->body.find("<script nonce=\"" + nonce + "\">"), std::string::npos);
    EXPECT_EQ(page->body.find("@NONCE@"), std::string::npos);
    EXPECT_NE(http.Get("/")->get_header_value("Content-Security-Policy"), policy);
    EXPECT_EQ(http.Get("/status")->body, R"({"ok":true,"shown":"x"})");
    EXPECT_EQ(http.Get("/metrics")->body, "metrics 1\n");
    EXPECT_TRUE(http.Get("/metrics")
                    ->get_header_value("Content-Type")
                    .starts_with("text/plain; version=0.0.4"));
    EXPECT_EQ(http.Get("/nothing")->status, 404);
    EXPECT_FALSE(http.Get("/status")->has_header("Access-Control-Allow-Origin"));
}

TEST_F(HttpServing, ForeignHostsAndOriginsAreRefused) {
    EXPECT_EQ(get("/status", host()), 200);
    EXPECT_EQ(get("/status", ""), 403);
    EXPECT_EQ(get("/status", "Host: evil.com\r\n"), 403);
    EXPECT_EQ(get("/", "Host: evil.com\r\n"), 403);
    EXPECT_EQ(get("/status", host() + "Host: evil.com\r\n"), 403);
    EXPECT_EQ(get("/status", host() + "Origin: http://evil.com\r\n"), 403);
    EXPECT_EQ(get("/status", host() + "Origin: null\r\n"), 403);
    const std::string own = "Origin: http://127.0.0.1:" + std::to_string(server->port()) + "\r\n";
    EXPECT_EQ(get("/status", host() + own), 200);
    EXPECT_EQ(get("/status", host() + own + "Origin: http://evil.com\r\n"), 403);
    EXPECT_EQ(statusOf(answerTo(server->port(), "OPTIONS /control HTTP/1.1\r\n" + host() +
                                                    "Origin: http://evil.com\r\n\r\n")),
              403);
}

TEST_F(HttpServing, PicturesAndControlsNeedTheToken) {
    auto http = client();
    const std::string wish = R"({"command":"set","name":"scale","value":"0.5"})";
    for (const httplib::Headers& wrong :
         {httplib::Headers{},
          {{"Authorization", kToken}},
          {{"Authorization", "Bearer x" + kToken}},
          {{"Cookie", "token=" + kToken}},
          {{"Authorization", "Bearer " + kToken}, {"Authorization", "Bearer x"}}}) {
        EXPECT_EQ(http.Post("/control", wrong, wish, "application/json")->status, 401);
        for (const char* path : {"/preview/color.png", "/preview/eye.png?x=0", "/preview/none"})
            EXPECT_EQ(http.Get(path, wrong)->status, 401) << path;
    }
    EXPECT_EQ(told, 0);
    const auto done = http.Post("/control", kAuthorized, wish, "application/json");
    EXPECT_EQ(done->status, 200);
    EXPECT_EQ(nlohmann::json::parse(done->body).at("name"), "scale");
    EXPECT_EQ(told, 1);
    start("");
    auto closed = client();
    EXPECT_EQ(closed.Get("/preview/color.png", kAuthorized)->status, 403);
    EXPECT_EQ(closed.Post("/control", kAuthorized, wish, "application/json")->status, 403);
    EXPECT_EQ(closed.Get("/status")->status, 200);
    EXPECT_EQ(told, 1);
}

TEST_F(HttpServing, ControlsAreThoseOfTheSocketAndNothingIsRecorded) {
    auto http = client();
    const auto post = [&](const std::string& body, const char* type = "application/json") {
        return http.Post("/control", kAuthorized, body, type)->status;
    };
    EXPECT_EQ(post(R"({"command":"status"})"), 200);
    EXPECT_EQ(post(R"({"command":"reload"})"), 200);
    EXPECT_EQ(post(R"({"command":"show","what":"live"})"), 200);
    EXPECT_EQ(post(R"({"command":"set","name":"colour","value":"1"})"), 400);
    const int before = told;
    for (const char* bad :
         {"", "{", "[]", R"({"command":"record"})", R"({"command":"snapshot","recording":true})",
          R"({"command":"run"})", R"({"command":"recording"})", "\xFF\xFE", "status"})
        EXPECT_EQ(post(bad), 400) << bad;
    EXPECT_EQ(post(R"({"command":"reload"})", "text/plain"), 415);
    EXPECT_EQ(post(R"({"command":"reload"})", "application/x-www-form-urlencoded"), 415);
    EXPECT_EQ(post(R"({"command":"reload"})", "multipart/form-data; boundary=x"), 415);
    EXPECT_EQ(http.Get("/control", kAuthorized)->status, 404);
    EXPECT_EQ(told, before);
}

TEST_F(HttpServing, PreviewsAreSmallPicturesOfWhatWasAskedFor) {
    auto http = client();
    const auto shadeOf = [&](const std::string& path) {
        const auto reply = http.Get(path, kAuthorized);
        EXPECT_EQ(reply->status, 200) << path;
        EXPECT_EQ(reply->get_header_value("Content-Type"), "image/png");
        devices::PngDecoder png;
        const auto header = png.open(std::as_bytes(std::span(reply->body)));
        EXPECT_EQ(header.size(), (devices::PictureSize{640, 360}));
        std::vector<std::byte> pixels(header.bytes());
        png.decode(pixels);
        return std::to_integer<int>(pixels[pixels.size() / 2]);
    };
    EXPECT_EQ(shadeOf("/preview/color.png"), 100);
    EXPECT_EQ(shadeOf("/preview/eye.png?x=-1"), 0);
    EXPECT_EQ(shadeOf("/preview/eye.png?x=0.5"), 150);
    const auto none = http.Get("/preview/depth.png", kAuthorized);
    EXPECT_EQ(none->status, 503);
    EXPECT_EQ(nlohmann::json::parse(none->body).at("error"), "nothing is shown");
    for (const char* x : {"", "left", "1.01", "-1.01", "nan", "inf", "0.5x", "1e999"})
        EXPECT_EQ(http.Get("/preview/eye.png?x=" + std::string(x), kAuthorized)->status, 400) << x;
}

TEST_F(HttpServing, TooManyPicturesASecondAreRefused) {
    auto http = client();
    bool refused = false;
    for (int i = 0; i < 200 && !refused; ++i) {
        const auto reply = http.Get("/preview/depth.png", kAuthorized);
        refused = reply->status == 429;
        EXPECT_EQ(reply->get_header_value("Retry-After"), refused ? "1" : "");
    }
    EXPECT_TRUE(refused);
    EXPECT_EQ(http.Get("/status")->status, 200) << "figures go on";
}

TEST_F(HttpServing, OversizeRequestsAreRefused) {
    const auto port = server->port();
    EXPECT_EQ(get("/status", host() + "X: " + std::string(9000, 'x') + "\r\n"), 431);
    EXPECT_EQ(get("/" + std::string(9000, 'x'), host()), 431);
    std::string many;
    for (int i = 0; i < 2000; ++i)
        many += "X: y\r\n";
    EXPECT_EQ(get("/status", host() + many), 431);
    EXPECT_EQ(statusOf(answerTo(port, std::string(100'000, 'x'))), 431);
    const std::string post = "POST /control HTTP/1.1\r\nAuthorization: Bearer " + kToken +
                             "\r\nContent-Type: application/json\r\n" + host();
    const auto with = [&](const std::string& rest) {
        return statusOf(answerTo(port, post + rest));
    };
    EXPECT_EQ(with("Content-Length: 4097\r\n\r\n" + std::string(4097, 'x')), 413);
    EXPECT_EQ(with("Content-Length: 99999999999999999999999\r\n\r\n"), 413);
    EXPECT_EQ(with("Content-Length: -1\r\n\r\n"), 400);
    EXPECT_EQ(with("Content-Length: 2\r\nContent-Length: 3\r\n\r\n{}"), 400);
    EXPECT_EQ(with("Transfer-Encoding: chunked\r\n\r\n2\r\n{}\r\n0\r\n\r\n"), 411);
    EXPECT_EQ(with("Content-Encoding: gzip\r\nContent-Length: 2\r\n\r\n{}"), 415);
    EXPECT_EQ(told, 0);
    EXPECT_EQ(with("Content-Length: 20\r\n\r\n{\"command\":\"reload\"}"), 200);
}

TEST_F(HttpServing, SlowRequestsEndInTime) {
    limits.request = milliseconds(50);
    start();
    const std::string post = "POST /control HTTP/1.1\r\nAuthorization: Bearer " + kToken +
                             "\r\nContent-Type: application/json\r\n" + host();
    EXPECT_EQ(statusOf(answerTo(server->port(), "")), 408);
    EXPECT_EQ(statusOf(answerTo(server->port(), "GET /status HTTP/1.1\r\nHost: ")), 408);
    const std::string half = answerTo(server->port(), post + "Content-Length: 20\r\n\r\n{");
    EXPECT_NE(statusOf(half), 200);
    EXPECT_EQ(told, 0);
}

TEST_F(HttpServing, RefusalsAreCountedByStatus) {
    limits.request = milliseconds(200);
    start();
    EXPECT_TRUE(server->refusals().empty());
    EXPECT_EQ(get("/status", host()), 200);
    EXPECT_EQ(get("/preview/color.png", host()), 401);
    EXPECT_EQ(get("/status", "Host: evil.com\r\n"), 403);
    EXPECT_EQ(get("/", host() + "Origin: null\r\n"), 403);
    EXPECT_EQ(get("/nothing", host()), 404);
    EXPECT_EQ(get("/status", host() + "Content-Length: 4097\r\n"), 413);
    EXPECT_EQ(get("/" + std::string(9000, 'x'), host()), 431);
    EXPECT_EQ(statusOf(answerTo(server->port(), "")), 408);
    const HttpRefusals::Counts expected{{401, 1}, {403, 2}, {404, 1}, {408, 1}, {413, 1}, {431, 1}};
    // A reply is counted once it is sent.
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (server->refusals() != expected && std::chrono::steady_clock::now() < end)
        std::this_thread::sleep_for(milliseconds(5));
    EXPECT_EQ(server->refusals(), expected);
}

TEST_F(HttpServing, MoreThanItServesAtOnceAreTurnedAway) {
    std::vector<devices::UniqueFd> idle; // these say nothing and wait for 30 s
    for (std::size_t i = 0; i < HttpLimits::kAtOnce; ++i)
        idle.push_back(test::dial(server->port()));
    // All that wait, and those in the kernel's own queue: at some point one is told 503.
    bool turnedAway = false;
    for (std::size_t i = 0; i < 4 * HttpLimits::kWaiting && !turnedAway; ++i) {
        auto next = test::dial(server->port());
        const timeval brief{0, 10'000};
        setsockopt(next.get(), SOL_SOCKET, SO_RCVTIMEO, &brief, sizeof brief);
        turnedAway = statusOf(test::hear(next)) == 503;
        idle.push_back(std::move(next));
    }
    EXPECT_TRUE(turnedAway);
    EXPECT_GT(server->refusals()[503], 0U);
    idle.clear();
    // Until the workers notice.
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    httplib::Result heard = client().Get("/status");
    while ((!heard || heard->status == 503) && std::chrono::steady_clock::now() < end)
        heard = client().Get("/status");
    ASSERT_TRUE(heard);
    EXPECT_EQ(heard->status, 200) << "the others are gone";
}

TEST_F(HttpServing, AProgramThatHangsIsNoReasonToHang) {
    limits.answer = milliseconds(20);
    start();
    asleep = true;
    EXPECT_EQ(client().Get("/status")->status, 503);
    asleep = false;
    limits.answer = milliseconds(30'000);
    start();
    EXPECT_EQ(client().Get("/status")->status, 200);
    asleep = true;
    const devices::UniqueFd waiting = test::dial(server->port());
    test::say(waiting, "GET /status HTTP/1.1\r\n" + host() + "\r\n");
    const devices::UniqueFd silent = test::dial(server->port());
    stop(); // the test's time limit says whether that takes 30 s
}

TEST_F(HttpServing, BytesThatAreNoRequestDoNoHarm) {
    limits.request = milliseconds(100);
    start();
    std::mt19937 random(8);
    const auto number = [&](std::size_t below) { return random() % below; };
    const std::string good = "POST /control?x=%41&y HTTP/1.1\r\n" + host() +
                             "Authorization: Bearer " + kToken +
                             "\r\nRange: bytes=0-9\r\nExpect: 100-continue\r\nContent-Length: 20"
                             "\r\n\r\n{\"command\":\"status\"}";
    for (int i = 0; i < 200; ++i) {
        std::string bytes = good;
        if (i % 4 == 0) { // noise that ends like a head
            bytes.assign(number(3000), '\0');
            for (char& byte : bytes)
                byte = static_cast<char>(random());
            bytes += "\r\n\r\n";
        }
        for (std::size_t k = number(20); k > 0; --k)
            bytes[number(bytes.size())] = static_cast<char>(random());
        if (i % 3 == 0) bytes.resize(number(bytes.size())); // half of it, then nothing
        const devices::UniqueFd socket = test::dial(server->port());
        test::say(socket, bytes);
        if (i % 5 != 0) ::shutdown(socket.get(), SHUT_WR);
        if (i % 7 != 0) (void)test::hear(socket);
    }
    // Ranges are read by a regular expression, which is recursive.
    (void)get("/status", host() + "Range: bytes=" + std::string(8000, '1') + "-\r\n");
    std::string ranges = "Range: bytes=0-0";
    while (ranges.size() < 8000)
        ranges += ",0-0";
    (void)get("/status", host() + ranges + "\r\n");
    EXPECT_EQ(client().Get("/status")->status, 200);
}

TEST_F(HttpServing, AnAddressThatIsTakenIsAnError) {
    const config::ListenAddress taken{"127.0.0.1", server->port(), true};
    EXPECT_THROW(HttpServer({taken, ""}), ControlError);
    EXPECT_EQ(server->address(), "http://127.0.0.1:" + std::to_string(server->port()) + "/");
}

} // namespace
} // namespace autostereo::daemon
