// A scene of triangles on a tracked barrier's panel (30 inch, 2560x1600): the Combiner against the
// algorithms before it (Kooima 2007, section 2.3 and table 2). CPU time of all threads (llvmpipe:
// the GPU's work is in it), medians, contenders take turns. Errors are against 3/3: of the panel,
// and of what the left eye sees of it through the barrier. As a table.
//
// bench_combiner MESH [COPIES...]    copies of the mesh beside and above each other, 1 to 64

#include "calib/band_map.hpp"
#include "calib/look.hpp"
#include "config/load.hpp"
#include "devices/mesh/open_mesh.hpp"
#include "gpu/gl/context.hpp"
#include "gpu/scene/line_screen_views.hpp"
#include "gpu/scene/scene_pipeline.hpp"
#include "tests/bench/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace autostereo;
using bench::cpuMs, bench::median, bench::psnrDb;

constexpr double kSeconds = 1;
constexpr int kRounds = 5;

/// Table 2 (GeForce 7900GTX), frames a second of Crater Lake with 172K and with 306K vertices; 0:
/// not among its rows.
struct Paper {
    double fewer = 0, more = 0;
};
constexpr Paper kThreeThree{16, 3};

struct Content {
    devices::mesh::MeshScene scene;
    gpu::SceneParams look;
    calib::DisplayProfile display;
};

/// A method and its panel.
class Contender {
  public:
    Contender(std::string label, Paper published, const calib::DisplayProfile& display)
        : name(std::move(label)), paper(published), width_(display.width), height_(display.height),
          color_(GL_RGBA8, width_, height_), depth_(GL_DEPTH_COMPONENT32F, width_, height_),
          panel_(gpu::gl::makeFramebuffer(color_, &depth_)) {}
    virtual ~Contender() = default;

    void round(bool counts) {
        const double start = cpuMs();
        draw(panel_.name());
        glFinish();
        if (counts) times.push_back(cpuMs() - start);
    }
    [[nodiscard]] std::vector<std::uint8_t> picture() const {
        return gpu::readFramebuffer(panel_.name(), width_, height_).pixels;
    }

    std::string name;
    Paper paper;
    std::vector<double> times;

  protected:
    virtual void draw(GLuint panel) = 0;

  private:
    int width_, height_;
    gpu::gl::Texture color_, depth_;
    gpu::gl::Framebuffer panel_;
};

class Direct final : public Contender {
  public:
    Direct(std::string label, Paper published, const Content& content, gpu::LineScreenMethod method)
        : Contender(std::move(label), published, content.display), content_(content),
          placement_(gpu::scenePlacement(extent(content.scene, gpu::uprightTurn(content.look.up)),
                                         content.look, content.display, aspect())),
          block_(gpu::sceneBlock(content.look, placement_, content.display, aspect())),
          model_(content.scene), eyes_(calib::nominalEyes(content.display)),
          views_(content.display, content.look.shading, method, {eyes_.at(0), eyes_.at(1)}) {}

  private:
    [[nodiscard]] double aspect() const {
        return static_cast<double>(content_.display.width) / content_.display.height;
    }
    void draw(GLuint panel) override {
        model_.place(content_.scene, kSeconds, placement_.transform(content_.look, kSeconds));
        views_.render(model_, block_, panel);
    }

    const Content& content_;
    gpu::ScenePlacement placement_;
    gpu::SceneBlock block_;
    gpu::SceneModel model_;
    std::vector<glm::dvec3> eyes_;
    gpu::LineScreenViews views_;
};

class Combiner final : public Contender {
  public:
    Combiner(std::string label, Paper published, const Content& content, double quality)
        : Contender(std::move(label), published, content.display),
          pipeline_(content.scene, content.look, params(quality), content.display,
                    content.display.width, content.display.height) {}

  private:
    static gpu::PipelineParams params(double quality) {
        gpu::PipelineParams params;
        params.synthesis.method = gpu::Method::Multipass;
        params.synthesis.tileScale = quality;
        params.synthesis.filter = quality < 1 ? gpu::TileFilter::Linear : gpu::TileFilter::Nearest;
        return params;
    }
    void draw(GLuint panel) override {
        pipeline_.prepare(kSeconds);
        pipeline_.show(panel);
    }

    gpu::ScenePipeline pipeline_;
};

/// So many of a mesh in a square.
devices::mesh::MeshScene copies(const devices::mesh::MeshScene& one, int count) {
    const devices::mesh::MeshExtent size = extent(one);
    const glm::dvec3 step = 1.05 * (size.high - size.low);
    const int across = static_cast<int>(std::ceil(std::sqrt(count)));
    devices::mesh::MeshScene all = one;
    all.nodes.clear();
    for (int i = 0; i < count; ++i) {
        const auto first = static_cast<int>(all.nodes.size());
        devices::mesh::MeshNode place;
        const int column = i % across, row = i / across;
        place.pose.translation = {column * step.x, row * step.y, 0};
        all.nodes.push_back(place);
        for (devices::mesh::MeshNode node : one.nodes) {
            node.parent = node.parent == devices::mesh::kNone ? first : first + 1 + node.parent;
            all.nodes.push_back(node);
        }
    }
    return all;
}

std::vector<std::unique_ptr<Contender>> contendersFor(const Content& content) {
    using Method = gpu::LineScreenMethod;
    std::vector<std::unique_ptr<Contender>> all;
    all.push_back(std::make_unique<Direct>("3/3", kThreeThree, content, Method::ThreeThree));
    all.push_back(std::make_unique<Direct>("1/1", Paper{47, 9}, content, Method::OneOne));
    all.push_back(std::make_unique<Direct>("4/1", Paper{}, content, Method::FourOne));
    all.push_back(std::make_unique<Combiner>("Combiner, 100 %", Paper{52, 9}, content, 1));
    all.push_back(std::make_unique<Combiner>("Combiner, 40 %", Paper{62, 9}, content, 0.4));
    return all;
}

std::string papers(Paper paper) {
    if (paper.more == 0) return "-";
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.1f, %.1f", paper.fewer / kThreeThree.fewer,
                  paper.more / kThreeThree.more);
    return text.data();
}

void measure(const Content& content, const char* shading) {
    const auto contenders = contendersFor(content);
    for (int round = 0; round <= kRounds; ++round)
        for (const auto& contender : contenders)
            contender->round(round > 0);
    const calib::DisplayOptics optics = calib::displayOptics(content.display).value();
    const auto seen = [&](const Contender& contender) {
        return calib::look(optics, {optics.lenses.aperture, 0},
                           calib::nominalEyes(content.display).front(), contender.picture())
            .rgb;
    };
    const auto panel = contenders.front()->picture(), eye = seen(*contenders.front());
    const double base = median(contenders.front()->times);
    for (const auto& contender : contenders) {
        const double ms = median(contender->times);
        std::printf("| %zu, %s | %s | %.0f | %.2f | %s | %.1f, %.1f |\n", content.scene.triangles(),
                    shading, contender->name.c_str(), ms, base / ms,
                    papers(contender->paper).c_str(), psnrDb(contender->picture(), panel),
                    psnrDb(seen(*contender), eye));
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: bench_combiner MESH [COPIES...]\n");
        return 2;
    }
    const devices::mesh::MeshScene one = devices::mesh::openMesh(argv[1]);
    std::vector<int> counts;
    for (int i = 2; i < argc; ++i)
        counts.push_back(std::clamp(std::atoi(argv[i]), 1, 64));
    if (counts.empty()) counts = {1, 9};
    const gpu::gl::SurfacelessContext context(false);
    std::printf("| triangles, shading | method | CPU ms | times 3/3 | the paper's | dB to 3/3: "
                "panel, seen |\n|---|---|---|---|---|---|\n");
    for (const int count : counts)
        for (const auto& [name, shading] : {std::pair{"none", gpu::SceneShading::None},
                                            {"per pixel", gpu::SceneShading::PerPixel}}) {
            Content content{copies(one, count), {}, config::loadDisplay("personal-varrier-30")};
            content.look.shading = shading;
            const calib::DisplayProfile& display = content.display;
            content.display.quilt = {2, 1, display.width, display.height};
            measure(content, name);
        }
}
