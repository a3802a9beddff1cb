#include "tests/stress/session/fault_kinds.hpp"

#include "daemon/control/control_socket.hpp"
#include "daemon/session/pattern_picture.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <thread>

#include <sys/resource.h>
#include <sys/socket.h>

namespace autostereo::test {

namespace {

using devices::Duration;
using std::chrono::milliseconds;

enum class Which { Depth, Color, Both };

milliseconds between(Random& random, int leastMs, int mostMs) {
    return milliseconds(std::uniform_int_distribution(leastMs, mostMs)(random));
}

/// Long enough to be missed (200 ms) whatever the phase.
milliseconds aWhile(Random& random) { return between(random, 350, 700); }

const devices::StreamCounters& stream(Rehearsal& rehearsal, Which which) {
    const devices::FeedCounters& feed = rehearsal.session().accounts().feed;
    return which == Which::Color ? feed.color : feed.depth;
}

std::uint64_t skipped(Rehearsal& rehearsal, const std::string& why) {
    const auto& skips = rehearsal.session().accounts().skipped;
    const auto found = skips.find(why);
    return found == skips.end() ? 0 : found->second;
}

/// Depth pixels with which the conditioner did that; the report has their mean per frame.
std::uint64_t conditioned(Rehearsal& rehearsal, const std::string& what) {
    const daemon::Report& report = rehearsal.session().accounts();
    const auto found =
        std::ranges::find(report.conditioner, what, &std::pair<std::string, double>::first);
    if (found == report.conditioner.end()) return 0;
    return static_cast<std::uint64_t>(found->second * static_cast<double>(report.presented));
}

std::function<void(Rehearsal&, Random&)> ordering(SensorFault fault, Which which, int leastMs,
                                                  int mostMs) {
    return [=](Rehearsal& rehearsal, Random& random) {
        const Duration amount = between(random, leastMs, mostMs);
        if (which != Which::Color) rehearsal.depth().give(fault, amount);
        if (which != Which::Depth) rehearsal.color().give(fault, amount);
        rehearsal.runFor(aWhile(random));
        rehearsal.depth().give(SensorFault::None);
        rehearsal.color().give(SensorFault::None);
    };
}

class Kinds {
  public:
    /// A sensor's fault; its amount in ms, where it has one.
    void sensor(const std::string& name, SensorFault fault, Which which, const std::string& counter,
                std::function<std::uint64_t(Rehearsal&)> count, int leastMs = 1, int mostMs = 1) {
        const char* const whose[] = {"depth ", "colour ", "both "};
        all.push_back({whose[static_cast<int>(which)] + name,
                       ordering(fault, which, leastMs, mostMs), counter, std::move(count)});
    }
    void reconnects(const std::string& name, SensorFault fault, Which which) {
        sensor(name, fault, which, "reconnects",
               [which](Rehearsal& r) { return stream(r, which).reconnects; });
    }
    void unpaired(const std::string& name, SensorFault fault, Which which, int leastMs = 1,
                  int mostMs = 1) {
        sensor(
            name, fault, which, "unpaired",
            [which](Rehearsal& r) { return stream(r, which).unpaired; }, leastMs, mostMs);
    }
    void damaged(Which which) {
        sensor("unreadable", SensorFault::Damaged, which, "damaged",
               [which](Rehearsal& r) { return stream(r, which).damaged; });
    }
    void harmless(const std::string& name, SensorFault fault, Which which) {
        sensor(name, fault, which, "live", [](Rehearsal& r) { return r.seen().live; });
    }
    void wrong(const std::string& name, SensorFault fault, Which which) {
        sensor(name, fault, which, "wrong pictures", [](Rehearsal& r) { return r.seen().wrong; });
    }
    void withoutDepth(const std::string& name, SensorFault fault) {
        sensor(name, fault, Which::Depth, "without depth",
               [](Rehearsal& r) { return r.session().accounts().withoutDepth; });
    }
    void stale(const std::string& name, SensorFault fault, int leastMs = 1, int mostMs = 1) {
        sensor(
            name, fault, Which::Both, "stale", [](Rehearsal& r) { return skipped(r, "stale"); },
            leastMs, mostMs);
    }

    std::vector<FaultKind> all;
};

void addSensors(Kinds& kinds) {
    for (const Which which : {Which::Depth, Which::Color, Which::Both}) {
        kinds.reconnects("unplugged", SensorFault::Unplugged, which);
        kinds.reconnects("slow to come", SensorFault::SlowToCome, which);
        kinds.sensor("silent", SensorFault::Silent, which, "steps not live",
                     [](Rehearsal& r) { return r.seen().notLive; });
        kinds.unpaired("flood", SensorFault::Flood, which);
        kinds.harmless("numbers jump", SensorFault::Numbered, which);
    }
    for (const Which which : {Which::Depth, Which::Color}) {
        kinds.reconnects("other size", SensorFault::OtherSize, which);
        kinds.reconnects("other format", SensorFault::OtherFormat, which);
        kinds.damaged(which);
        kinds.unpaired("time back", SensorFault::Back, which, 60, 20'000);
        kinds.unpaired("time forward", SensorFault::Forward, which, 60, 20'000);
        kinds.unpaired("time extreme", SensorFault::Extreme, which);
        kinds.unpaired("time stuck", SensorFault::Stuck, which);
        kinds.unpaired("twice", SensorFault::Twice, which);
        kinds.harmless("one number", SensorFault::Repeated, which);
    }
    kinds.sensor("burst", SensorFault::Burst, Which::Both, "unpaired, dropped, stale",
                 [](Rehearsal& r) {
                     return stream(r, Which::Depth).unpaired + r.session().accounts().feed.dropped +
                            skipped(r, "stale");
                 });
    kinds.stale("late", SensorFault::Late, 250, 340); // shorter than it lasts
    kinds.unpaired("late", SensorFault::Late, Which::Color, 100, 300);
    // Nearest in time is still somebody.
    kinds.sensor(
        "jitter", SensorFault::Jitter, Which::Both, "live",
        [](Rehearsal& r) { return r.seen().live; }, 25, 40);
    kinds.harmless("clock drifts", SensorFault::Drift, Which::Color);
    kinds.withoutDepth("all zero", SensorFault::Zero);
    kinds.withoutDepth("saturated", SensorFault::Saturated);
    kinds.wrong("black", SensorFault::Zero, Which::Color);
    kinds.wrong("garbage", SensorFault::Garbage, Which::Color);
    kinds.sensor("garbage", SensorFault::Garbage, Which::Depth, "flying pixels",
                 [](Rehearsal& r) { return conditioned(r, "flying"); });
}

void setStorm(Rehearsal& rehearsal, Random& random) {
    const auto end = std::chrono::steady_clock::now() + aWhile(random);
    const char* const names[] = {"scale", "focus", "brightness", "mode", "scale", "method"};
    const char* const values[] = {"0.5", "2", "0.3", "2d", "minus", "instanced"};
    while (std::chrono::steady_clock::now() < end) {
        const auto i = random() % std::size(names);
        rehearsal.ask(daemon::SetRequest{names[i], values[i]});
    }
    rehearsal.ask(daemon::ReloadRequest{});
}

void hangingClients(Rehearsal& rehearsal, Random& random) {
    constexpr int kClients = 20;
    std::vector<devices::UniqueFd> clients;
    for (int i = 0; i < kClients; ++i) {
        clients.push_back(daemon::connectTo(rehearsal.socket()));
        const std::string words = i % 2 == 0 ? "{\"command\":" : "{\"command\":\"snapshot\"}\n";
        static_cast<void>(::send(clients.back().get(), words.data(), words.size(), MSG_NOSIGNAL));
    }
    rehearsal.runFor(aWhile(random));
    rehearsal.ask(daemon::StatusRequest{});
}

/// The recording's file may not grow any more.
void fullDisk(Rehearsal& rehearsal, Random& random) {
    const auto before = std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit tight{1, limit.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &tight);
    rehearsal.runFor(aWhile(random) + milliseconds(1000)); // the recorder looks back for 0.5 s
    ::setrlimit(RLIMIT_FSIZE, &limit);
    static_cast<void>(std::signal(SIGXFSZ, before));
}

void addOperators(Kinds& kinds) {
    const auto refused = [](Rehearsal& r) { return r.refused(); };
    const auto answered = [](Rehearsal& r) { return r.answered(); };
    const auto reloading = [](const char* lines) {
        return [lines](Rehearsal& rehearsal, Random& random) {
            rehearsal.configure(lines);
            rehearsal.ask(daemon::ReloadRequest{});
            rehearsal.runFor(between(random, 0, 200));
            rehearsal.configure();
            rehearsal.ask(daemon::ReloadRequest{});
        };
    };
    kinds.all.push_back({"reload, unknown key", reloading("nonsense = 1\n"), "refused", refused});
    kinds.all.push_back(
        {"reload, no such rig", reloading("input.rig = \"none.toml\"\n"), "refused", refused});
    kinds.all.push_back({"reload, other picture",
                         reloading("picture.brightness = 0.2\nframing.mirror = true\n"), "answered",
                         answered});
    kinds.all.push_back({"set storm", setStorm, "answered", answered});
    kinds.all.push_back({"clients hang", hangingClients, "answered", answered});
    kinds.all.push_back({"pattern",
                         [](Rehearsal& rehearsal, Random& random) {
                             rehearsal.session().showPattern(daemon::patternNamed("numbers"));
                             rehearsal.runFor(aWhile(random));
                             rehearsal.session().showPattern(std::nullopt);
                         },
                         "skipped", [](Rehearsal& r) { return skipped(r, "pattern"); }});
}

void addMachine(Kinds& kinds) {
    kinds.all.push_back(
        {"panel stands",
         [](Rehearsal&, Random& random) { std::this_thread::sleep_for(aWhile(random)); },
         "unpaired",
         [](Rehearsal& r) {
             return stream(r, Which::Depth).unpaired + r.session().accounts().feed.dropped;
         }});
    kinds.all.push_back({"disk full", fullDisk, "left out",
                         [](Rehearsal& r) { return r.session().accounts().recording->leftOut; }});
    kinds.all.push_back({"recording deleted",
                         [](Rehearsal& rehearsal, Random& random) {
                             std::filesystem::remove(rehearsal.recording());
                             rehearsal.runFor(aWhile(random));
                         },
                         "written, left out",
                         [](Rehearsal& r) {
                             const auto& counters = *r.session().accounts().recording;
                             return counters.written + counters.leftOut;
                         }});
}

} // namespace

std::vector<FaultKind> faultKinds() {
    Kinds kinds;
    addSensors(kinds);
    addOperators(kinds);
    addMachine(kinds);
    return std::move(kinds.all);
}

} // namespace autostereo::test
