#include "tests/bench/views/match.hpp"

#include "config/load.hpp"
#include "gpu/views/method_choice.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::bench {

namespace {

/// The first pair of an input that has both streams and knows its cameras.
test::CapturedPair capture(const std::string& uri) {
    devices::Input input = devices::openInput(uri);
    if (!input.depth || !input.color || !input.rig)
        throw devices::DeviceError("bench: " + uri +
                                   " has not both depth and colour with their calibration");
    return test::takePair(std::move(input), 0);
}

calib::DisplayProfile displayOf(const Case& wanted) {
    calib::DisplayProfile display = config::loadDisplay(wanted.display);
    if (wanted.views == 0) return display;
    display.views = wanted.views;
    display.remap.clear();
    const int columns = static_cast<int>(std::ceil(std::sqrt(wanted.views)));
    display.quilt = {columns, (wanted.views + columns - 1) / columns, wanted.tileWidth,
                     wanted.tileHeight};
    return display;
}

/// One texel per depth pixel, divided by `stride` each way.
FusedInput fuse(const calib::DisplayProfile& display, int stride, const test::CapturedPair& pair) {
    FusedInput input;
    input.params.fusion.density = 1.0 / stride;
    input.params.fusion.mostTexels = 2'000'000;
    input.params.synthesis.method = gpu::Method::Direct; // prepares nothing large
    input.pipeline = std::make_unique<gpu::Pipeline>(input.params, pair.rig, display, display.width,
                                                     display.height);
    input.pipeline->prepare(pair.frame);
    return input;
}

gpu::SynthesisParams method(gpu::Method method) {
    gpu::SynthesisParams params;
    params.method = method;
    params.positions = gpu::ViewPositions::OfViews;
    params.keepRoots = false; // the scene stands still: nothing would be searched
    return params;
}

gpu::SynthesisParams nearest(gpu::SynthesisParams params) {
    params.filter = gpu::TileFilter::Nearest;
    return params;
}

gpu::SynthesisParams keeping(gpu::SynthesisParams params) {
    params.keepRoots = true;
    return params;
}

gpu::SynthesisParams continuous(gpu::SynthesisParams params) {
    params.positions = gpu::ViewPositions::Continuous;
    return params;
}

gpu::SynthesisParams referring(int references, gpu::SynthesisParams params) {
    params.references = references;
    return params;
}

std::string contenderOf(gpu::Method method) {
    if (method == gpu::Method::Hybrid)
        return "hybrid, " + std::to_string(gpu::SynthesisParams{}.references);
    return std::string(gpu::methodName(method));
}

} // namespace

Match::Match(const Case& wanted)
    : case_(wanted), display_(displayOf(wanted)), pair_(capture(wanted.scene)),
      full_(fuse(display_, 1, pair_)), half_(fuse(display_, 2, pair_)),
      quarter_(fuse(display_, 4, pair_)) {
    const auto multipass = method(gpu::Method::Multipass), direct = method(gpu::Method::Direct);
    add("multipass", full_, multipass);
    add("multipass, half the mesh", half_, multipass);
    add("multipass, quarter", quarter_, multipass);
    add("instanced", full_, method(gpu::Method::Instanced));
    add("geometry", full_, method(gpu::Method::Geometry));
    add("mrt", full_, method(gpu::Method::Layered));
    for (const int references : {2, 3, 4})
        add("hybrid, " + std::to_string(references), full_,
            referring(references, method(gpu::Method::Hybrid)));
    add("direct", full_, direct);
    add("direct, only colour changed", full_, keeping(direct));
    add("direct, continuous", full_, continuous(direct));
    add("phase and one texel", full_, nearest(method(gpu::Method::Instanced)),
        Contender::Part::Show);
}

std::vector<Row> Match::run(int rounds, int bands, const std::string& suite) {
    for (int round = 0; round <= rounds; ++round)
        for (const auto& contender : contenders_)
            contender->round(round > 0);
    full_.use();
    const oracle::SearchInput in =
        test::searchInput(pair_.rig, *full_.pipeline, test::readPicture(full_.pipeline->color()));
    const Judge ofViews = judge(in, bands, gpu::ViewPositions::OfViews);
    const Judge ofPhases = judge(in, bands, gpu::ViewPositions::Continuous);
    std::vector<Row> rows;
    for (const auto& contender : contenders_) {
        const bool every = contender->synthesis().positions == gpu::ViewPositions::Continuous;
        rows.push_back(row(*contender, every ? ofPhases : ofViews, suite));
    }
    for (Row& row : rows)
        row.ratioToMultipass = rows.front().cpuMs / row.cpuMs;
    for (const double leastDb : {30.0, 40.0, 55.0})
        rows.push_back(chosen(rows, leastDb));
    return rows;
}

void Match::add(const std::string& name, const FusedInput& input,
                const gpu::SynthesisParams& synthesis, Contender::Part part) {
    contenders_.push_back(std::make_unique<Contender>(name, input, synthesis, display_,
                                                      display_.width, display_.height, part));
}

Judge Match::judge(const oracle::SearchInput& in, int bands, gpu::ViewPositions positions) const {
    return {in,
            oracle::SearchedPanel(display_, display_.width, display_.height, positions,
                                  oracle::channelStepPx(display_)),
            display_.width, display_.height, bands};
}

Row Match::row(const Contender& contender, const Judge& judge, const std::string& suite) const {
    const Judgement error = judge.judge(contender.picture());
    const devices::FrameMetadata& depth = pair_.frame.depth.metadata();
    return {suite,
            case_.scene,
            case_.display,
            std::to_string(depth.width) + "x" + std::to_string(depth.height),
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

Row Match::chosen(const std::vector<Row>& rows, double leastDb) const {
    gpu::PipelineParams params = full_.params;
    params.synthesis = method(gpu::Method::Auto);
    params.synthesis.leastDb = leastDb;
    full_.use();
    const gpu::MethodChoice choice = gpu::chooseMethod(params, display_, display_.width,
                                                       display_.height, full_.pipeline->scene());
    const std::string name = contenderOf(choice.method);
    Row row = *std::ranges::find(rows, name, &Row::method);
    row.method = "auto, " + std::to_string(static_cast<int>(leastDb)) + " dB: " + name;
    return row;
}

} // namespace autostereo::bench
