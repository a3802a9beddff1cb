#include "config/load.hpp"
#include "devices/sim/simulation.hpp"
#include "gpu/gl/context.hpp"
#include "tests/bench/views/contender.hpp"
#include "tests/bench/views/judge.hpp"
#include "tests/bench/views/row.hpp"
#include "tests/gl/search_support.hpp"

#include <cmath>
#include <stdexcept>

namespace autostereo::bench {

namespace {

struct Case {
    std::string scene;   ///< simulation and its options
    std::string display; ///< profile
    int width, height;   ///< depth camera
    int views;           ///< 0: the display's own
};

struct Suite {
    std::vector<Case> cases;
    int rounds;
    int bands; ///< of 8 rows each that are judged
};

Suite suiteNamed(const std::string& name) {
    const Case portrait{"room?noise=off", "looking-glass-portrait", 640, 480, 0};
    const Case slanted{"person?noise=off", "slanted-8view-1080p", 320, 288, 0};
    const Case barrier{"person?noise=off", "barrier-5view", 176, 144, 0};
    const Case tracked{"person?noise=off", "personal-varrier-30", 640, 480, 0};
    if (name == "quick") return {{portrait, slanted, barrier, tracked}, 3, 4};
    if (name != "full")
        throw std::invalid_argument("bench: --suite " + name +
                                    " is not known (allowed quick, full)");
    Suite suite{{portrait, slanted, barrier, tracked}, 5, 12};
    for (const int views : {8, 100})
        suite.cases.push_back({"room?noise=off", "looking-glass-portrait", 640, 480, views});
    for (const auto& [width, height] : {std::pair{176, 144}, std::pair{640, 576}})
        suite.cases.push_back({"room?noise=off", "looking-glass-portrait", width, height, 0});
    suite.cases.push_back({"person", "looking-glass-portrait", 640, 480, 0});
    suite.cases.push_back({"room?noise=off", "looking-glass-8k-gen1", 640, 480, 100});
    return suite;
}

calib::DisplayProfile displayOf(const Case& wanted) {
    calib::DisplayProfile display = config::loadDisplay(wanted.display);
    if (wanted.views == 0) return display;
    display.views = wanted.views;
    display.remap.clear();
    const int columns = static_cast<int>(std::ceil(std::sqrt(wanted.views)));
    display.quilt = {columns, (wanted.views + columns - 1) / columns, 512, 512};
    return display;
}

/// One texel per depth pixel, divided by `stride` each way.
FusedInput fuse(const calib::DisplayProfile& display, int stride, const test::SimulatedPair& pair) {
    FusedInput input;
    input.params.fusion.density = 1.0 / stride;
    input.params.fusion.mostTexels = 2'000'000;
    input.params.synthesis.method = gpu::Method::Direct; // prepares nothing large
    input.pipeline = std::make_unique<gpu::Pipeline>(input.params, pair.rig, display, display.width,
                                                     display.height);
    input.pipeline->prepare(pair.frame);
    return input;
}

gpu::SynthesisParams method(gpu::Method method,
                            gpu::ViewPositions positions = gpu::ViewPositions::OfViews) {
    gpu::SynthesisParams params;
    params.method = method;
    params.positions = positions;
    return params;
}

gpu::SynthesisParams hybrid(int references) {
    gpu::SynthesisParams params = method(gpu::Method::Hybrid);
    params.references = references;
    return params;
}

/// Runs one configuration; contenders take turns.
class Match {
  public:
    Match(const Case& wanted, const calib::DisplayProfile& display)
        : case_(wanted), display_(display), pair_(test::simulate(uri(wanted))),
          full_(fuse(display, 1, pair_)), half_(fuse(display, 2, pair_)),
          quarter_(fuse(display, 4, pair_)) {
        using Part = Contender::Part;
        add("multipass", full_, method(gpu::Method::Multipass), Part::All);
        add("multipass, half the mesh", half_, method(gpu::Method::Multipass), Part::All);
        add("multipass, quarter", quarter_, method(gpu::Method::Multipass), Part::All);
        add("instanced", full_, method(gpu::Method::Instanced), Part::All);
        add("geometry", full_, method(gpu::Method::Geometry), Part::All);
        add("mrt", full_, method(gpu::Method::Layered), Part::All);
        for (const int references : {2, 3, 4})
            add("hybrid, " + std::to_string(references), full_, hybrid(references), Part::All);
        add("direct", full_, method(gpu::Method::Direct), Part::All);
        add("direct, continuous", full_,
            method(gpu::Method::Direct, gpu::ViewPositions::Continuous), Part::All);
        add("interleaving alone", full_, method(gpu::Method::Instanced), Part::Show);
    }

    std::vector<Row> run(const Suite& suite, const std::string& name) {
        for (int round = 0; round <= suite.rounds; ++round)
            for (const auto& contender : contenders_)
                contender->round(round > 0);
        full_.use();
        const oracle::SearchInput in =
            test::searchInput(pair_.rig, *full_.pipeline, test::colorPicture(pair_.frame.color));
        const Judge views = judge(in, suite.bands, gpu::ViewPositions::OfViews);
        const Judge continuous = judge(in, suite.bands, gpu::ViewPositions::Continuous);
        std::vector<Row> rows;
        for (const auto& contender : contenders_) {
            const bool every = contender->synthesis().positions == gpu::ViewPositions::Continuous;
            rows.push_back(row(*contender, every ? continuous : views, name));
        }
        for (Row& row : rows)
            row.ratioToMultipass = rows.front().cpuMs / row.cpuMs;
        return rows;
    }

  private:
    static std::string uri(const Case& wanted) {
        const char joint = wanted.scene.find('?') == std::string::npos ? '?' : '&';
        return "sim:" + wanted.scene + joint +
               "color=1280x960&depth=" + std::to_string(wanted.width) + "x" +
               std::to_string(wanted.height);
    }
    void add(const std::string& name, const FusedInput& input,
             const gpu::SynthesisParams& synthesis, Contender::Part part) {
        contenders_.push_back(std::make_unique<Contender>(name, input, synthesis, display_,
                                                          display_.width, display_.height, part));
    }
    [[nodiscard]] Judge judge(const oracle::SearchInput& in, int bands,
                              gpu::ViewPositions positions) const {
        return {in, oracle::SearchedPanel(display_, display_.width, display_.height, positions),
                display_.width, display_.height, bands};
    }
    [[nodiscard]] Row row(const Contender& contender, const Judge& judge,
                          const std::string& suite) const {
        const Judgement error = judge.judge(contender.picture());
        return {suite,
                case_.scene,
                case_.display,
                std::to_string(case_.width) + "x" + std::to_string(case_.height),
                display_.views,
                contender.name(),
                contender.wallMs(),
                contender.cpuMs(),
                contender.gpuMs(),
                error.psnrDb,
                error.ssim,
                error.errMax,
                error.badPct,
                contender.memoryMib(),
                0};
    }

    Case case_;
    calib::DisplayProfile display_;
    test::SimulatedPair pair_;
    FusedInput full_, half_, quarter_;
    std::vector<std::unique_ptr<Contender>> contenders_;
};

} // namespace

std::vector<Row> run(const std::string& suite, void (*progress)(const std::string&)) {
    const Suite wanted = suiteNamed(suite);
    const gpu::gl::SurfacelessContext context(false);
    std::vector<Row> rows;
    for (const Case& each : wanted.cases) {
        progress(each.scene + " " + std::to_string(each.width) + "x" + std::to_string(each.height) +
                 " on " + each.display);
        const calib::DisplayProfile display = displayOf(each);
        const std::vector<Row> found = Match(each, display).run(wanted, suite);
        rows.insert(rows.end(), found.begin(), found.end());
    }
    return rows;
}

} // namespace autostereo::bench
