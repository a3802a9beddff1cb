#include "tests/replay/kiosk.hpp"

#include "calib/message_picture.hpp"

#include <csignal>
#include <thread>

namespace autostereo::test {

namespace {

constexpr std::chrono::milliseconds kPatience{20'000 * kSlower};

} // namespace

ColorPicture plainMessage(const std::string& text) {
    const calib::Picture picture = calib::messagePicture({}, text, kSmallWidth, kSmallHeight);
    ColorPicture expected{picture.width, picture.height, {}};
    for (std::size_t i = 0; i < picture.pixels.size(); ++i)
        if (i % 4 != 3) expected.rgb.push_back(picture.pixels[i]);
    return expected;
}

bool eventually(const std::function<bool()>& what, std::chrono::milliseconds limit) {
    const auto deadline = std::chrono::steady_clock::now() + limit;
    while (!what()) {
        if (std::chrono::steady_clock::now() > deadline) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return true;
}

Kiosk::Kiosk(const std::string& config, const std::string& display)
    : display_(display.empty() ? smallDisplay(folder_) : folder_.file("display.toml", display)) {
    configure(config);
}

void Kiosk::configure(const std::string& config) const {
    (void)folder_.file("kiosk.toml", "input.wait = \"yes\"\ninput.uri = \"" +
                                         std::string(kSmallPerson) +
                                         "&noise=off&plug=" + folder_ / "" +
                                         "\"\ncontrol.socket = \"" + socket() + "\"\n" + config);
}

void Kiosk::start(std::vector<std::string> more, std::vector<std::string> environment) {
    std::vector<std::string> words{"run",       "--config", folder_ / "kiosk.toml",
                                   "--display", display_,   "--output",
                                   "offscreen", "--frames", "1000000"};
    words.insert(words.end(), more.begin(), more.end());
    auto call = calling(std::move(words));
    call.environment.insert(call.environment.end(), environment.begin(), environment.end());
    program_ = std::make_unique<RunningProgram>(call);
    ASSERT_TRUE(eventually([&] { return command({"status"}).exitCode == 0; }, kPatience));
}

ProgramResult Kiosk::command(std::vector<std::string> words) const {
    words.insert(words.end(), {"--socket", socket()});
    return runProgram(calling(std::move(words)));
}

nlohmann::json Kiosk::status() const {
    const ProgramResult result = command({"status", "--json"});
    EXPECT_TRUE(succeeded(result));
    return nlohmann::json::parse(result.out, nullptr, false);
}

bool Kiosk::shows(const std::string& what, std::chrono::milliseconds limit) const {
    return eventually([&] { return status().value("shown", "") == what; }, limit * kSlower);
}

ColorPicture Kiosk::snapshot() const {
    const std::string file = folder_ / "snapshot.png";
    EXPECT_TRUE(succeeded(command({"snapshot", file})));
    return readColor(file);
}

ProgramResult Kiosk::stop() {
    program_->signal(SIGTERM);
    return program_->wait();
}

} // namespace autostereo::test
