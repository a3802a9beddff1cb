#include "gpu/gl/context.hpp"
#include "tests/bench/views/match.hpp"

#include <stdexcept>

namespace autostereo::bench {

namespace {

struct Suite {
    std::vector<Case> cases;
    int rounds;
    int bands; ///< of 8 rows each that are judged
};

std::string simulated(const std::string& scene, const std::string& depth, bool noise = false) {
    return "sim:" + scene + "?color=1280x960&depth=" + depth + (noise ? "" : "&noise=off");
}

Suite suiteNamed(const std::string& name) {
    const std::string room = simulated("room", "640x480");
    Suite suite{{{room, "looking-glass-portrait"},
                 {simulated("person", "320x288"), "slanted-8view-1080p"},
                 {simulated("person", "176x144"), "barrier-5view"},
                 {simulated("person", "640x480"), "personal-varrier-30"}},
                3,
                4};
    if (name == "quick") return suite;
    if (name != "full")
        throw std::invalid_argument("bench: --suite " + name +
                                    " is not known (allowed quick, full)");
    suite.rounds = 5;
    suite.bands = 12;
    for (const int views : {8, 100})
        suite.cases.push_back({room, "looking-glass-portrait", views});
    for (const char* grid : {"176x144", "640x576"})
        suite.cases.push_back({simulated("room", grid), "looking-glass-portrait"});
    suite.cases.push_back({simulated("person", "640x480", true), "looking-glass-portrait"});
    suite.cases.push_back({room, "looking-glass-8k-gen1", 100});
    // de Sorbier 2010: five views and one of 1024x768 each from a 176x144 depth camera.
    for (const int views : {5, 1})
        suite.cases.push_back({simulated("person", "176x144"), "barrier-5view", views, 1024, 768});
    return suite;
}

/// The suite's displays, or the one wanted; the suite's scenes, or the one given.
std::vector<Case> casesOf(const Suite& suite, const Request& request) {
    std::vector<Case> cases;
    if (!request.input.empty() && !request.display.empty())
        return {{request.input, request.display}};
    for (Case each : suite.cases) {
        if (!request.display.empty() && each.display != request.display) continue;
        if (!request.input.empty()) each.scene = request.input;
        cases.push_back(each);
    }
    return cases;
}

} // namespace

std::vector<Row> run(const Request& request, void (*progress)(const std::string&)) {
    const Suite suite = suiteNamed(request.suite);
    const gpu::gl::SurfacelessContext context(false);
    std::vector<Row> rows;
    for (const Case& each : casesOf(suite, request)) {
        progress(each.scene + " on " + each.display);
        const std::vector<Row> found = Match(each).run(suite.rounds, suite.bands, request.suite);
        rows.insert(rows.end(), found.begin(), found.end());
    }
    return rows;
}

} // namespace autostereo::bench
