// Scenes of triangles, from the model to the full panel, by way of every view's triangles or of a
// few reference viewpoints: CPU time of all threads (llvmpipe: the GPU's work is in it), medians,
// contenders take turns. Errors are against the panel whose every sub-pixel is drawn from its own
// view's eye at its own place, and against multipass' panel. As a table.
//
// bench_scene MESH [VIEWS...]

#include "calib/panel_map.hpp"
#include "config/load.hpp"
#include "devices/mesh/open_mesh.hpp"
#include "gpu/gl/context.hpp"
#include "gpu/scene/scene_pipeline.hpp"
#include "tests/bench/figures.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace autostereo;
using bench::cpuMs, bench::median, bench::psnrDb;

constexpr double kSeconds = 1;
constexpr int kRounds = 5;

calib::DisplayProfile displayOf(int views) {
    calib::DisplayProfile display = config::loadDisplay("looking-glass-portrait");
    display.views = views;
    int columns = static_cast<int>(std::ceil(std::sqrt(views)));
    while (views % columns != 0)
        ++columns;
    display.quilt.columns = columns;
    display.quilt.rows = views / columns;
    return display;
}

/// A method and its panel.
struct Contender {
    Contender(const devices::mesh::MeshScene& scene, const calib::DisplayProfile& display,
              gpu::Method method, int references, double scale)
        : name(gpu::methodName(method)), target(GL_RGBA8, display.width, display.height),
          panel(gpu::gl::makeFramebuffer(target)) {
        gpu::PipelineParams params;
        params.synthesis.method = method;
        params.synthesis.references = std::max(2, references);
        params.synthesis.tileScale = scale;
        params.synthesis.positions = gpu::ViewPositions::OfViews; // which all methods can show
        if (references > 0) name += ", " + std::to_string(references);
        if (scale < 1) name += ", texels as multipass";
        const auto before = gpu::gl::usage().bytes;
        pipeline = std::make_unique<gpu::ScenePipeline>(scene, gpu::SceneParams{}, params, display,
                                                        display.width, display.height);
        draw(false);
        mib = static_cast<double>(gpu::gl::usage().bytes - before) / (1024 * 1024);
    }
    void draw(bool counts) {
        const double start = cpuMs();
        pipeline->prepare(kSeconds);
        pipeline->show(panel.name());
        glFinish();
        if (counts) times.push_back(cpuMs() - start);
    }
    [[nodiscard]] gpu::RgbImage picture() const {
        return gpu::readFramebuffer(panel.name(), target.width(), target.height());
    }

    std::string name;
    gpu::gl::Texture target;
    gpu::gl::Framebuffer panel;
    std::unique_ptr<gpu::ScenePipeline> pipeline;
    std::vector<double> times;
    double mib = 0;
};

/// Each view three times as wide as the panel, so that its sub-pixels are pixels.
gpu::RgbImage exactPanel(gpu::ScenePipeline& pipeline, const calib::DisplayProfile& display) {
    const auto map =
        std::get<calib::ViewMap>(calib::panelMap(display, display.width, display.height));
    gpu::RgbImage panel{display.width, display.height, {}};
    panel.pixels.resize(3 * static_cast<std::size_t>(display.width) *
                        static_cast<std::size_t>(display.height));
    const std::vector<glm::dvec3> eyes = gpu::viewEyes(display);
    for (int view = 0; view < display.views; ++view) {
        const gpu::RgbImage seen = pipeline.renderEye(eyes[static_cast<std::size_t>(view)],
                                                      3 * display.width, display.height);
        for (int y = 0; y < display.height; ++y)
            for (int x = 0; x < display.width; ++x)
                for (int c = 0; c < 3; ++c) {
                    if (static_cast<int>(map.view(map.phase(x, y, c))) != view) continue;
                    const int at = 3 * (y * display.width + x) + c;
                    panel.pixels[static_cast<std::size_t>(at)] =
                        seen.pixels[3 * static_cast<std::size_t>(at) + static_cast<std::size_t>(c)];
                }
    }
    return panel;
}

void measure(const devices::mesh::MeshScene& scene, int views) {
    const calib::DisplayProfile display = displayOf(views);
    std::vector<std::unique_ptr<Contender>> contenders;
    const auto add = [&](gpu::Method method, int references, double scale) {
        contenders.push_back(
            std::make_unique<Contender>(scene, display, method, references, scale));
    };
    add(gpu::Method::Multipass, 0, 1);
    add(gpu::Method::Instanced, 0, 1);
    add(gpu::Method::Hybrid, 3, 1);
    add(gpu::Method::Hybrid, 4, 1);
    add(gpu::Method::Direct, 4, 0.5); // which searches twice as many texels each way
    add(gpu::Method::Direct, 4, 1);
    for (int round = 0; round < kRounds; ++round)
        for (const auto& contender : contenders)
            contender->draw(true);
    const gpu::RgbImage exact = exactPanel(*contenders.front()->pipeline, display);
    const gpu::RgbImage multipass = contenders.front()->picture();
    const double base = median(contenders.front()->times);
    for (const auto& contender : contenders) {
        const gpu::RgbImage picture = contender->picture();
        const double ms = median(contender->times);
        std::printf("| %d | %s | %.0f | %.2f | %.2f | %.2f | %.1f |\n", views,
                    contender->name.c_str(), ms, base / ms, psnrDb(picture.pixels, exact.pixels),
                    psnrDb(picture.pixels, multipass.pixels), contender->mib);
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: bench_scene MESH [VIEWS...]\n");
        return 2;
    }
    const devices::mesh::MeshScene scene = devices::mesh::openMesh(argv[1]);
    std::vector<int> views;
    for (int i = 2; i < argc; ++i)
        views.push_back(std::clamp(std::atoi(argv[i]), 1, 1000));
    if (views.empty()) views = {8, 28, 48, 100};
    const gpu::gl::SurfacelessContext context(false);
    std::printf("%zu triangles\n| views | method | CPU ms | times multipass | dB, exact | dB, "
                "multipass | MiB |\n|---|---|---|---|---|---|---|\n",
                scene.triangles());
    for (const int count : views)
        measure(scene, count);
}
