// What exact views cost: the fixed-point interleaver against the same pass in plain float, and
// against a pass that only fetches one texel per channel. One process, interleaved order, medians;
// beside the time the sub-pixels that plain float puts into another view.
// usage: bench_interleaver [rounds]

#include "calib/panel_map.hpp"
#include "gpu/blocks.hpp"
#include "gpu/gl/context.hpp"
#include "gpu/gl/shader_source.hpp"
#include "gpu/gl/uniform_buffer.hpp"
#include "gpu/interleaver.hpp"
#include "gpu/readback.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <stdexcept>

namespace {

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own file

constexpr const char* kVertex = R"(#version 450 core
void main() {
    vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
})";

// Both rivals read tiles by the real pass's own code; its block's `edge` carries the phase law:
// per column, per row, per channel, offset.
constexpr const char* kFloat = R"(
layout(location = 0) out vec4 color;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float y = float(panel.y - 1 - pixel.y);
    float phase = edge.x * float(pixel.x) + edge.y * y + edge.w;
    vec3 phases = fract(phase + edge.z * vec3(0.0, 1.0, 2.0));
    ivec3 views = ivec3(phases * float(fan.x));
    Place place = placeOf(pixel);
    color = vec4(samplePlace(views.x, place, 0), samplePlace(views.y, place, 1),
                 samplePlace(views.z, place, 2), 1.0);
})";

constexpr const char* kFetchOnly = R"(
layout(location = 0) out vec4 color;
void main() {
    Place place = placeOf(ivec2(gl_FragCoord.xy));
    color = vec4(samplePlace(0, place, 0), samplePlace(1, place, 1), samplePlace(2, place, 2), 1.0);
})";

// The same with neighbouring sub-pixels in other views, as every panel has them: what the cache
// misses of an interleaved panel cost without any phase.
constexpr const char* kSpreadFetch = R"(
layout(location = 0) out vec4 color;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Place place = placeOf(pixel);
    int k = 3 * pixel.x + pixel.y;
    color = vec4(samplePlace(k & 31, place, 0), samplePlace((k + 1) & 31, place, 1),
                 samplePlace((k + 2) & 31, place, 2), 1.0);
})";

gpu::gl::ShaderName shader(GLenum stage, const std::string& source) {
    gpu::gl::ShaderName name(glCreateShader(stage));
    const char* text = source.c_str();
    glShaderSource(name.name(), 1, &text, nullptr);
    glCompileShader(name.name());
    GLint good = 0;
    glGetShaderiv(name.name(), GL_COMPILE_STATUS, &good);
    if (good == 0) throw std::runtime_error("a rival does not compile");
    return name;
}

/// A rival pass over the same atlas and panel.
class Rival {
  public:
    Rival(const char* body, const calib::LinearPhase& law, const gpu::AtlasLayout& layout,
          int width, int height)
        : program_(glCreateProgram()), vertexArray_(gpu::gl::makeVertexArray()) {
        const auto vertex = shader(GL_VERTEX_SHADER, kVertex);
        const auto fragment = shader(
            GL_FRAGMENT_SHADER, "#version 450 core\n" +
                                    gpu::gl::shaderSource("interleaver_block.glsl", {"NEAREST"}) +
                                    gpu::gl::shaderSource("tile_samples.glsl", {}) + body);
        glAttachShader(program_.name(), vertex.name());
        glAttachShader(program_.name(), fragment.name());
        glLinkProgram(program_.name());
        const calib::QuiltLayout& quilt = layout.quilt;
        block_.fan.x = static_cast<std::uint32_t>(layout.views);
        block_.tiles = {quilt.columns, quilt.tileWidth, quilt.tileHeight, 0};
        block_.panel = {width, height, 1, 1};
        block_.edge = {static_cast<float>(law.perColumn), static_cast<float>(law.perRow),
                       static_cast<float>(law.channels[0][1]), static_cast<float>(law.offset)};
        block_.scale = {static_cast<float>(quilt.tileWidth) / static_cast<float>(width),
                        static_cast<float>(quilt.tileHeight) / static_cast<float>(height), 0.0F,
                        0.0F};
        const auto columns = static_cast<std::uint32_t>(quilt.columns);
        block_.atlasRow.x = ((1U << 20) + columns - 1) / columns;
    }
    void render(const gpu::Atlas& atlas, GLuint framebuffer) {
        uniforms_.bind(2, block_);
        glUseProgram(program_.name());
        glBindTextureUnit(0, atlas.color().name());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
        glViewport(0, 0, block_.panel.x, block_.panel.y);
        glBindVertexArray(vertexArray_.name());
        glDrawArrays(GL_TRIANGLES, 0, 3);
    }

  private:
    gpu::gl::ProgramName program_;
    gpu::gl::VertexArray vertexArray_;
    gpu::InterleaverBlock block_;
    gpu::gl::UniformBuffer<gpu::InterleaverBlock> uniforms_;
};

double milliseconds(const std::function<void()>& pass) {
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    pass();
    glFinish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

double median(std::vector<double>& values) {
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

gpu::Atlas noisyAtlas(const gpu::AtlasLayout& layout) {
    gpu::Atlas atlas(layout);
    std::vector<std::uint32_t> texels(static_cast<std::size_t>(layout.width()) *
                                      static_cast<std::size_t>(layout.height()));
    std::uint32_t state = 1;
    for (std::uint32_t& texel : texels)
        texel = state = state * 1664525U + 1013904223U;
    glTextureSubImage2D(atlas.color().name(), 0, 0, 0, layout.width(), layout.height(), GL_RGBA,
                        GL_UNSIGNED_BYTE, texels.data());
    return atlas;
}

calib::LinearPhase phaseLaw(int width) {
    calib::LinearPhase law;
    law.perColumn = -246.88 / width;
    law.perRow = -0.0224;
    law.channels = {{0, law.perColumn / 3, 2 * law.perColumn / 3}};
    law.offset = 0.2937;
    return law;
}

/// Sub-pixels that differ, as a share: what plain float gets wrong.
double differing(const gpu::RgbImage& a, const gpu::RgbImage& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        count += a.pixels[i] != b.pixels[i];
    return static_cast<double>(count) / static_cast<double>(a.pixels.size());
}

void compare(int width, int height, const gpu::AtlasLayout& layout, int rounds) {
    calib::DisplayProfile display;
    display.width = width;
    display.height = height;
    display.views = layout.views;
    display.law = phaseLaw(width);
    const gpu::Atlas atlas = noisyAtlas(layout);
    const gpu::gl::Texture target(GL_RGBA8, width, height), other(GL_RGBA8, width, height);
    const auto panel = gpu::gl::makeFramebuffer(target), second = gpu::gl::makeFramebuffer(other);
    const auto exact =
        gpu::makeInterleaver(calib::panelMap(display, width, height), width, height,
                             {gpu::TileFilter::Nearest, gpu::ViewFilter::Nearest, 0});
    Rival plain(kFloat, phaseLaw(width), layout, width, height);
    Rival fetch(kFetchOnly, phaseLaw(width), layout, width, height);
    Rival spread(kSpreadFetch, phaseLaw(width), layout, width, height);

    std::array<std::vector<double>, 4> times;
    constexpr int kWarmUp = 3;
    for (int round = -kWarmUp; round < rounds; ++round) {
        const std::array<double, 4> taken{
            milliseconds([&] {
                exact->render({&atlas, nullptr}, panel.name());
            }),
            milliseconds([&] { plain.render(atlas, second.name()); }),
            milliseconds([&] { fetch.render(atlas, second.name()); }),
            milliseconds([&] { spread.render(atlas, second.name()); })};
        for (std::size_t i = 0; i < taken.size() && round >= 0; ++i)
            times.at(i).push_back(taken.at(i));
    }
    plain.render(atlas, second.name());
    const double wrong = differing(gpu::readFramebuffer(panel.name(), width, height),
                                   gpu::readFramebuffer(second.name(), width, height));
    const double fixed = median(times[0]), floating = median(times[1]), only = median(times[2]),
                 apart = median(times[3]);
    std::printf(
        "{\"suite\": \"interleaver\", \"panel\": \"%dx%d\", \"views\": %d, "
        "\"fixed_ms\": %.2f, \"float_ms\": %.2f, \"fetch_only_ms\": %.2f, "
        "\"ratio_to_float\": %.3f, \"ratio_to_fetch_only\": %.3f, \"ratio_to_spread_fetch\": %.3f, "
        "\"float_differs_share\": %.6f}\n",
        width, height, layout.views, fixed, floating, only, fixed / floating, fixed / only,
        fixed / apart, wrong);
}

} // namespace

int main(int argc, char** argv) try {
    const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 21;
    const gpu::gl::SurfacelessContext context(false);
    compare(1536, 2048, {48, {8, 6, 420, 560}}, rounds);
    compare(3840, 2160, {45, {5, 9, 819, 455}}, rounds);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
