#include "tests/stress/session/rehearsal.hpp"

#include "daemon/control/control_client.hpp"
#include "daemon/control/control_socket.hpp"
#include "daemon/log.hpp"
#include "daemon/session/pattern_picture.hpp"
#include "tests/support/image_compare.hpp"
#include "tests/support/small_display.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <future>
#include <stdexcept>

namespace autostereo::test {

namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr int kWidth = 160, kHeight = 90;
/// A picture depends a little on those before it: on which of them a mean was begun, on what was
/// seen behind. Wrong ones are a person's step or a grey frame away, 20 dB and less.
constexpr double kRightDb = 26;

} // namespace

Rehearsal::Rehearsal(const ScratchFolder& folder, const Scene& scene)
    : folder_(folder), scene_(scene) {
    folder_.write("tiny.toml", smallDisplayText(kWidth, kHeight));
    configure();
    daemon::RunOptions options;
    options.scene.config = folder_ / "kiosk.toml";
    options.output = config::Output::Offscreen;
    options.frames = std::uint64_t{1} << 40U;
    if (!scene.record.empty()) options.record = folder_ / scene.record;
    const config::Config config = daemon::configuration(options.scene);
    daemon::setUpLog(config.log.level);
    session_ = std::make_unique<daemon::Session>(options, config, [this](devices::Input input) {
        return staged(std::move(input), depth_, color_, scene_.pictures, scene_.period);
    });
    desk_ = std::make_unique<daemon::ControlDesk>(options, config, *session_);
    learn();
}

void Rehearsal::configure(const std::string& more) const {
    // Where the scene is put has no one right answer after a disturbance: it has a dead band.
    folder_.write("kiosk.toml",
                  "input.uri = \"" + scene_.input + "\"\ninput.wait = \"no\"\n" +
                      "display.profile = \"tiny.toml\"\noutput.kind = \"offscreen\"\n" +
                      "depth.focus_m = 1.5\ndepth.scale = 1\nidle.freeze_s = 0.3\n" +
                      "control.socket = \"" + socket().string() + "\"\nlog.level = \"error\"\n" +
                      more);
}

void Rehearsal::ask(const daemon::ControlRequest& request) {
    auto answer = std::async(std::launch::async, [&] {
        const devices::UniqueFd socket = daemon::connectTo(this->socket());
        return daemon::ask(socket.get(), request).line;
    });
    while (answer.wait_for(milliseconds(0)) != std::future_status::ready)
        step();
    const bool good = nlohmann::json::parse(answer.get()).at("ok");
    ++(good ? answered_ : refused_);
}

void Rehearsal::learn() {
    // Two rounds until means and background have settled, then each picture once.
    constexpr std::chrono::seconds kPatience{60};
    const auto round = scene_.period * (std::max<std::size_t>(scene_.pictures, 40));
    const auto settled = Clock::now() + 2 * round, limit = settled + kPatience;
    right_.resize(scene_.pictures);
    const auto known = [&] {
        return std::ranges::none_of(right_, [](const auto& p) { return p.empty(); });
    };
    while (!known()) {
        if (Clock::now() > limit) throw std::runtime_error("this machine is too slow to rehearse");
        step();
        if (newest_ && Clock::now() > settled && right_[*newest_].empty())
            right_[*newest_] = session_->picture().pixels;
    }
    // What is made when it is first needed: a still picture's texture, one for other colours.
    session_->showPattern(daemon::patternNamed("numbers"));
    runFor(milliseconds(100));
    session_->showPattern(std::nullopt);
    color_.give(SensorFault::OtherFormat);
    runFor(milliseconds(700));
    color_.give(SensorFault::None);
    static_cast<void>(untilRight(milliseconds(5000)));
    forget();
}

std::optional<std::size_t> Rehearsal::newPicture() {
    const daemon::Status status = session_->status();
    if (status.shown != "live" || !status.capturedAt) return std::nullopt;
    if (shown_ == status.capturedAt) return std::nullopt;
    shown_ = status.capturedAt;
    return StagedSensor::exposureAt(*shown_, scene_.period) % scene_.pictures;
}

bool Rehearsal::isRight(std::size_t number) {
    if (right_[number].empty()) return true; // while they are learned
    const gpu::RgbImage image = session_->picture();
    const double psnr =
        compareImages({image.pixels, kWidth, kHeight, 3}, {right_[number], kWidth, kHeight, 3})
            .psnrDb;
    if (psnr >= kRightDb) seen_.leastPsnrDb = std::min(seen_.leastPsnrDb, psnr);
    return psnr >= kRightDb;
}

void Rehearsal::pass() {
    if (!session_->step()) throw std::runtime_error("the session has ended");
    desk_->serve();
}

void Rehearsal::step() {
    const auto start = devices::SteadyClock().now();
    pass();
    const daemon::Status status = session_->status();
    if (status.shown == "live" && status.capturedAt) noteAge(start, status);
    if (status.shown != "live") ++seen_.notLive;
    newest_ = newPicture();
    if (!newest_) return;
    spacings_ = {spacings_[1], status.now - newestAt_};
    newestAt_ = status.now;
    drawn_ = status.now - start;
    lastWasRight_ = isRight(*newest_);
    ++seen_.live;
    if (!lastWasRight_) ++seen_.wrong;
}

void Rehearsal::noteAge(devices::TimePoint stepBegan, const daemon::Status& status) {
    const auto ms = [](devices::Duration time) {
        return std::chrono::duration<double, std::milli>(time).count();
    };
    // As it was when the step looked for a newer one. Drawing does not count, nor does what this
    // machine is too slow for: three spacings of the last pictures are allowed.
    const devices::Duration age = stepBegan - *status.capturedAt;
    const devices::Duration allowed =
        std::max<devices::Duration>(milliseconds(200), 3 * std::ranges::max(spacings_)) + drawn_;
    seen_.oldestMs = std::max(seen_.oldestMs, ms(age));
    seen_.overdueMs = std::max(seen_.overdueMs, ms(age - allowed));
}

void Rehearsal::runFor(milliseconds time) {
    for (const auto end = Clock::now() + time; Clock::now() < end;)
        step();
}

std::optional<milliseconds> Rehearsal::untilRight(milliseconds limit) {
    constexpr int kInARow = 3;
    const auto start = Clock::now();
    int row = 0;
    milliseconds since{0};
    while (Clock::now() - start < limit) {
        step();
        if (!newest_) continue;
        if (row == 0) since = std::chrono::duration_cast<milliseconds>(Clock::now() - start);
        row = lastWasRight_ ? row + 1 : 0;
        if (row == kInARow) return since;
    }
    return std::nullopt;
}

} // namespace autostereo::test
