// The operator's page of a running program: what it says over HTTP, and what a browser makes of it.

#include "tests/replay/browser.hpp"
#include "tests/replay/kiosk.hpp"
#include "tests/support/data.hpp"
#include "tests/support/prometheus_text.hpp"

#include <gtest/gtest.h>
#include <httplib.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <regex>
#include <thread>
#include <utility>

namespace autostereo::test {
namespace {

using std::chrono::milliseconds;

const std::string kToken = "token-of-this-test-0123456789";

struct Page : testing::Test {
    void SetUp() override {
        (void)kiosk.folder().file("token", kToken);
        std::filesystem::permissions(kiosk.folder() / "token", std::filesystem::perms::owner_all);
    }
    void start() {
        kiosk.start();
        ASSERT_TRUE(kiosk.shows("live", milliseconds(10'000)));
        const std::string log = kiosk.program().err();
        std::smatch found;
        ASSERT_TRUE(std::regex_search(log, found, std::regex("(http://127.0.0.1:([0-9]+)/)")))
            << log;
        address = found[1];
        http = std::make_unique<httplib::Client>("127.0.0.1", std::stoi(found[2]));
        http->set_read_timeout(30);
    }
    void startMoving() {
        kiosk.configure(kSettings);
        kiosk.plugBoth();
        start();
    }
    /// Nothing moves, so that pictures can be compared.
    void startStill(const std::string& settings = kSettings) {
        (void)kiosk.folder().file("kiosk.toml", "input.uri = \"" + std::string(kSmallRoom) +
                                                    "&noise=off\"\ncontrol.socket = \"" +
                                                    kiosk.socket() + "\"\n" + settings);
        start();
    }
    void TearDown() override {
        if (!http) return;
        EXPECT_TRUE(succeeded(kiosk.stop()));
    }
    /// A PNG file's bytes; empty where there is none.
    [[nodiscard]] std::string picture(const std::string& path) const {
        // The rate of pictures is limited; whoever asks too often waits.
        for (;;) {
            const auto reply = http->Get(path, {{"Authorization", "Bearer " + kToken}});
            if (!reply || reply->status != 429)
                return reply && reply->status == 200 ? reply->body : "";
            std::this_thread::sleep_for(milliseconds(200));
        }
    }
    [[nodiscard]] int tell(const std::string& wish) const {
        const auto reply = http->Post("/control", {{"Authorization", "Bearer " + kToken}}, wish,
                                      "application/json");
        return reply ? reply->status : 0;
    }

    static constexpr const char* kSettings =
        "http.listen = \"127.0.0.1:0\"\nhttp.token_file = \"token\"\n";
    Kiosk kiosk;
    std::string address;
    std::unique_ptr<httplib::Client> http;
};

TEST_F(Page, FiguresAreThoseOfTheStatusCommand) {
    startMoving();
    const auto status = nlohmann::json::parse(http->Get("/status")->body);
    const auto same = kiosk.status();
    std::vector<std::string> keys, sameKeys;
    for (const auto& [key, value] : status.items())
        keys.push_back(key);
    for (const auto& [key, value] : same.items())
        sameKeys.push_back(key);
    EXPECT_EQ(keys, sameKeys);
    EXPECT_EQ(status.at("panel"), same.at("panel"));
    EXPECT_EQ(status.at("settings"), same.at("settings"));

    const auto before = kiosk.status().at("report");
    const auto samples = prometheusSamples(http->Get("/metrics")->body);
    const auto after = kiosk.status().at("report");
    const auto between = [&](const std::string& name, const char* key) {
        EXPECT_LE(before.at(key).get<double>(), samples.at(name)) << name;
        EXPECT_GE(after.at(key).get<double>(), samples.at(name)) << name;
    };
    between("autostereo_pairs_total", "frames_in");
    between("autostereo_frames_presented_total", "frames_presented");
    between("autostereo_frames_dropped_total", "frames_dropped");
    between("autostereo_uptime_seconds", "seconds");
    EXPECT_EQ(samples.at("autostereo_latency_seconds_count"),
              samples.at("autostereo_frames_presented_total"));
    EXPECT_EQ(samples.at("autostereo_sensor_state{sensor=\"depth\",state=\"streaming\"}"), 1);
    EXPECT_GT(samples.at("process_resident_memory_bytes"), 10e6);
}

TEST_F(Page, ControlsTakeEffectAndNothingElseDoes) {
    startMoving();
    EXPECT_EQ(tell(R"({"command":"set","name":"scale","value":"0.5"})"), 200);
    EXPECT_EQ(kiosk.status().at("settings").at("scale"), 0.5);
    EXPECT_EQ(tell(R"({"command":"set","name":"scale","value":"99"})"), 400);
    EXPECT_EQ(kiosk.status().at("settings").at("scale"), 0.5);
    EXPECT_EQ(tell(R"({"command":"show","what":"numbers"})"), 200);
    EXPECT_EQ(kiosk.status().at("shown"), "pattern");
    EXPECT_EQ(picture("/preview/eye.png"), "") << "what is not shown is not to be seen";
    EXPECT_EQ(tell(R"({"command":"show","what":"live"})"), 200);
    EXPECT_EQ(tell(R"({"command":"reload"})"), 200);
    EXPECT_EQ(kiosk.status().at("settings").at("scale"), "auto");
    EXPECT_TRUE(kiosk.shows("live", milliseconds(5000)));
}

TEST_F(Page, PreviewsAreOfTheSceneAndTheSnapshotIsThePanel) {
    startStill();
    std::string middle;
    ASSERT_TRUE(eventually( // what is remembered of the scene comes to rest
        [&] { return std::exchange(middle, picture("/preview/eye.png?x=0")) == middle; },
        milliseconds(20'000 * kSlower)));
    EXPECT_NE(picture("/preview/eye.png?x=1"), middle);
    EXPECT_NE(picture("/preview/eye.png?x=-1"), picture("/preview/eye.png?x=1"));
    EXPECT_EQ(picture("/preview/eye.png"), middle);
    const auto read = [&](const std::string& bytes) {
        return readColor(kiosk.folder().file("preview.png", bytes));
    };
    const ColorPicture eye = read(middle), depth = read(picture("/preview/depth.png")),
                       color = read(picture("/preview/color.png"));
    for (const ColorPicture* any : {&eye, &depth, &color}) {
        EXPECT_EQ(any->width, 320);
        EXPECT_EQ(any->height, 180);
        EXPECT_GT(contrast(*any), 5);
    }
    const auto reply = http->Post("/control", {{"Authorization", "Bearer " + kToken}},
                                  R"({"command":"snapshot"})", "application/json");
    ASSERT_EQ(reply->status, 200);
    EXPECT_EQ(read(reply->body), kiosk.snapshot());
}

// Coarser than what `render` draws, but of the same eye: as near to it as to no other.
TEST_F(Page, TheEyePreviewIsWhatAnEyeThereSees) {
    const std::string depth = "depth.scale = 1\ndepth.focus_m = 1.5\n";
    startStill(std::string(kSettings) + depth);
    const std::string still = kiosk.folder().file("still.toml", depth);
    const double edge = std::tan(25.64 / 2 * std::numbers::pi / 180); // of the fan at 1 m
    const std::vector<double> places{-0.9, 0, 0.9};
    std::vector<ColorPicture> rendered, seen;
    for (const double place : places) {
        const std::string file = kiosk.folder() / "view.png";
        const auto result = runProgram(
            calling({"render", "--config", still, "--input", std::string(kSmallRoom) + "&noise=off",
                     "--display", kiosk.folder() / "small.toml", "--as", "view", "--eye",
                     std::to_string(place * edge) + ",0,1", "--output", file}));
        ASSERT_TRUE(succeeded(result));
        rendered.push_back(readColor(file));
        seen.push_back(readColor(kiosk.folder().file(
            "preview.png", picture("/preview/eye.png?x=" + std::to_string(place)))));
    }
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t k = 0; k < places.size(); ++k) {
            const double psnr = compareImages(seen[i].view(), rendered[k].view()).psnrDb;
            const double own = compareImages(seen[i].view(), rendered[i].view()).psnrDb;
            EXPECT_TRUE(i == k || own > psnr + 3)
                << places[i] << ": " << own << " dB; " << places[k] << ": " << psnr << " dB";
        }
}

TEST_F(Page, PreviewsLeaveThePanelAsItIs) {
    startStill();
    ASSERT_TRUE(eventually(
        [&] { return kiosk.status().at("report").at("skipped").value("unchanged", 0) > 0; },
        milliseconds(20'000 * kSlower)));
    const ColorPicture before = kiosk.snapshot();
    for (const char* path : {"/preview/color.png", "/preview/depth.png", "/preview/eye.png?x=1"})
        EXPECT_NE(picture(path), "") << path;
    EXPECT_EQ(kiosk.snapshot(), before);
    // Drawn anew from the same frame.
    EXPECT_EQ(tell(R"({"command":"set","name":"mode","value":"2d"})"), 200);
    EXPECT_NE(kiosk.snapshot(), before);
    EXPECT_EQ(tell(R"({"command":"set","name":"mode","value":"3d"})"), 200);
    EXPECT_EQ(kiosk.snapshot(), before);
}

struct PageInBrowser : Page {
    void SetUp() override {
        if (const auto missing = missingBrowser()) {
            if (required("browser")) FAIL() << *missing;
            GTEST_SKIP() << *missing;
        }
        Page::SetUp();
    }
    void visit(const std::string& fragment = "#token=" + kToken) {
        browser = std::make_unique<Browser>();
        browser->resize(1280, 900, false);
        browser->open(address + fragment);
    }
    void TearDown() override {
        // Pictures may be refused meanwhile; nothing else is.
        for (const auto& error : browser ? browser->errors() : nlohmann::json::array())
            EXPECT_NE(error.get<std::string>().find("/preview/"), std::string::npos) << error;
        browser.reset();
        Page::TearDown();
    }
    /// A small copy of a picture on the page, as numbers; null where there is none yet.
    [[nodiscard]] nlohmann::json pixels(const std::string& picture) const {
        return browser->run("const image = document.getElementById(arguments[0] + '-picture');"
                            "if (!image.naturalWidth) return null;"
                            "const canvas = document.createElement('canvas');"
                            "canvas.width = 64; canvas.height = 36;"
                            "const paper = canvas.getContext('2d');"
                            "paper.drawImage(image, 0, 0, 64, 36);"
                            "return Array.from(paper.getImageData(0, 0, 64, 36).data);",
                            {picture});
    }
    [[nodiscard]] bool comes(const std::string& script) const {
        return eventually([&] { return browser->run("return Boolean(" + script + ')') == true; },
                          milliseconds(30'000 * kSlower));
    }
    /// Left for a person to look at where $AUTOSTEREO_SCREENSHOTS names a folder.
    void screenshot(const std::string& name) const {
        if (const char* folder = std::getenv("AUTOSTEREO_SCREENSHOTS"))
            browser->screenshot(std::string(folder) + '/' + name + ".png");
    }

    std::unique_ptr<Browser> browser;
};

TEST_F(PageInBrowser, LoadsAndItsPicturesMove) {
    startMoving();
    visit();
    for (const char* picture : {"eye", "color", "depth"}) {
        nlohmann::json first;
        ASSERT_TRUE(eventually([&] { return !(first = pixels(picture)).is_null(); },
                               milliseconds(30'000 * kSlower)))
            << picture;
        EXPECT_TRUE(
            eventually([&] { return pixels(picture) != first; }, milliseconds(30'000 * kSlower)))
            << picture;
    }
    EXPECT_TRUE(comes("document.getElementById('state').textContent.startsWith('live')"));
    EXPECT_TRUE(comes("Number(document.getElementById('rate').textContent) > 0"));
    EXPECT_TRUE(comes("document.querySelectorAll('#latency rect').length == 15"));
    EXPECT_TRUE(comes("document.getElementById('frames').textContent.includes('dropped')"));
    EXPECT_TRUE(comes("document.getElementById('door').hidden"));
    EXPECT_EQ(browser->run("return location.hash"), "") << "the token stays in no history";
    screenshot("desktop");
}

TEST_F(PageInBrowser, TheSliderMovesTheEye) {
    startStill();
    visit();
    const auto seenFrom = [&](const char* place) {
        browser->run("const eye = document.getElementById('eye'); eye.value = arguments[0];"
                     "eye.dispatchEvent(new Event('input'))",
                     {place});
        EXPECT_TRUE(comes("document.getElementById('eye-picture').dataset.query === '?x=" +
                          std::string(place) + "'"));
        return pixels("eye");
    };
    nlohmann::json middle = seenFrom("0.00");
    ASSERT_TRUE(eventually([&] { return std::exchange(middle, seenFrom("0.00")) == middle; },
                           milliseconds(30'000 * kSlower)));
    const auto right = seenFrom("0.80"), left = seenFrom("-0.80");
    EXPECT_NE(right, middle);
    EXPECT_NE(left, middle);
    EXPECT_NE(left, right);
    EXPECT_EQ(seenFrom("0.00"), middle);
}

TEST_F(PageInBrowser, ControlsReachTheProgram) {
    startMoving();
    visit();
    ASSERT_TRUE(comes("!document.getElementById('scale').disabled"));
    browser->run("document.querySelector('[data-value=\"2d\"]').click()");
    EXPECT_TRUE(eventually([&] { return kiosk.status().at("settings").at("mode") == "2d"; },
                           milliseconds(10'000 * kSlower)));
    EXPECT_TRUE(comes(
        "document.querySelector('[data-value=\"2d\"]').getAttribute('aria-pressed') === 'true'"));
    browser->run("const dim = document.getElementById('brightness'); dim.value = 0.5;"
                 "dim.dispatchEvent(new Event('change'))");
    EXPECT_TRUE(eventually([&] { return kiosk.status().at("settings").at("brightness") == 0.5; },
                           milliseconds(10'000 * kSlower)));
    browser->run("const show = document.getElementById('show'); show.value = 'numbers';"
                 "show.dispatchEvent(new Event('change'))");
    EXPECT_TRUE(kiosk.shows("pattern", milliseconds(10'000)));
    EXPECT_TRUE(comes("document.getElementById('state').textContent.startsWith('pattern')"));
}

TEST_F(PageInBrowser, AsksForTheTokenAndShowsFiguresMeanwhile) {
    startMoving();
    visit("");
    EXPECT_TRUE(comes("!document.getElementById('door').hidden"));
    EXPECT_TRUE(comes("document.getElementById('scale').disabled"));
    EXPECT_TRUE(comes("Number(document.getElementById('rate').textContent) > 0"));
    EXPECT_TRUE(pixels("eye").is_null());
    screenshot("token");
    browser->run("document.getElementById('token').value = arguments[0];"
                 "document.querySelector('#door button').click()",
                 {kToken});
    EXPECT_TRUE(comes("document.getElementById('eye-picture').naturalWidth > 0"));
    EXPECT_TRUE(comes("document.getElementById('door').hidden"));
    EXPECT_TRUE(comes("!document.getElementById('scale').disabled"));
}

TEST_F(PageInBrowser, FitsAPhone) {
    startMoving();
    visit();
    browser->resize(390, 844, true);
    for (const std::string picture : {"eye", "color", "depth"})
        EXPECT_TRUE(comes("document.getElementById('" + picture + "-picture').naturalWidth > 0"));
    EXPECT_TRUE(comes("document.getElementById('frames').childElementCount > 0"));
    EXPECT_EQ(browser->run("return window.innerWidth"), 390);
    EXPECT_EQ(browser->run("return document.documentElement.scrollWidth"), 390)
        << "no horizontal scroll";
    screenshot("phone");
}

} // namespace
} // namespace autostereo::test
