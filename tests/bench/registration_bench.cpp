// Depth at the colour camera: our pass against cv::rgbd::registerDepth and against drawing the
// depth grid once. One process, interleaved order, medians; beside the time the error and the
// completeness against rays cast into the simulated scene.
// usage: bench_registration [rounds]

#include "devices/sim/simulation.hpp"
#include "gpu/depth_registration.hpp"
#include "gpu/gl/context.hpp"
#include "gpu/gl/shader_source.hpp"
#include "gpu/mesh_nodes.hpp"
#include "tests/oracle/registration_truth.hpp"

#include <opencv2/core.hpp>
#include <opencv2/rgbd/depth.hpp>

#include <array>
#include <cstdio>
#include <ctime>
#include <functional>
#include <stdexcept>

namespace {

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own file

constexpr double kMillimetre = 0.001;

// Both cameras in the vertex shader, every triangle, no depth test: the least that a renderer does
// to draw the grid at the colour camera.
constexpr const char* kPlainVertex = R"(
layout(binding = 0) uniform sampler2D rays;
layout(binding = 1) uniform usampler2D depthCounts;
layout(location = 0) out float depth;
void main() {
    int width = textureSize(depthCounts, 0).x;
    ivec2 node = ivec2(gl_VertexID % width, gl_VertexID / width);
    float z = float(texelFetch(depthCounts, node, 0).x) * budget.z;
    vec3 point = inColorCamera(texelFetch(rays, node, 0).xy, z);
    depth = point.z;
    gl_Position = vec4((2.0 * sourceOf(point) - 1.0) * point.z, 0.0, point.z);
})";
constexpr const char* kPlainFragment = R"(#version 450 core
layout(location = 0) in float depth;
layout(location = 0) out float metres;
void main() { metres = depth; })";

gpu::gl::ShaderName shader(GLenum stage, const std::string& source) {
    gpu::gl::ShaderName name(glCreateShader(stage));
    const char* text = source.c_str();
    glShaderSource(name.name(), 1, &text, nullptr);
    glCompileShader(name.name());
    GLint good = 0;
    glGetShaderiv(name.name(), GL_COMPILE_STATUS, &good);
    if (good == 0) throw std::runtime_error("the plain drawing does not compile");
    return name;
}

std::vector<GLuint> gridTriangles(int width, int height) {
    std::vector<GLuint> indices;
    const auto w = static_cast<GLuint>(width);
    for (int y = 0; y + 1 < height; ++y)
        for (int x = 0; x + 1 < width; ++x) {
            const auto first = static_cast<GLuint>(y * width + x);
            indices.insert(indices.end(),
                           {first, first + w, first + 1, first + 1, first + w, first + w + 1});
        }
    return indices;
}

/// One plain draw of the whole grid.
class PlainDraw {
  public:
    PlainDraw(const calib::SensorRig& rig, int width, int height)
        : program_(glCreateProgram()), rays_(gpu::makeRays(rig.depth)),
          target_(GL_R32F, width, height), framebuffer_(gpu::gl::makeFramebuffer(target_)),
          vertexArray_(gpu::gl::makeVertexArray()) {
        std::string head = "#version 450 core\n";
        for (const char* part : {"mesh_block.glsl", "camera.glsl", "color_camera.glsl"})
            head += gpu::gl::shaderSource(part, {});
        const auto vertex = shader(GL_VERTEX_SHADER, head + kPlainVertex);
        const auto fragment = shader(GL_FRAGMENT_SHADER, kPlainFragment);
        glAttachShader(program_.name(), vertex.name());
        glAttachShader(program_.name(), fragment.name());
        glLinkProgram(program_.name());
        const auto indices = gridTriangles(rays_.width(), rays_.height());
        count_ = static_cast<GLsizei>(indices.size());
        indices_ = gpu::gl::makeBuffer(indices.size() * sizeof(GLuint), indices.data(), 0);
        glVertexArrayElementBuffer(vertexArray_.name(), indices_.name());
        gpu::setCameras(block_, rig, {}, kMillimetre);
    }
    void render(const gpu::gl::Texture& counts) {
        constexpr std::array<float, 4> kNone{};
        uniforms_.bind(0, block_);
        glUseProgram(program_.name());
        glBindTextureUnit(0, rays_.name());
        glBindTextureUnit(1, counts.name());
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer_.name());
        glClearNamedFramebufferfv(framebuffer_.name(), GL_COLOR, 0, kNone.data());
        glViewport(0, 0, target_.width(), target_.height());
        glBindVertexArray(vertexArray_.name());
        glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
    }

  private:
    gpu::gl::ProgramName program_;
    gpu::MeshBlock block_;
    gpu::gl::UniformBuffer<gpu::MeshBlock> uniforms_;
    gpu::gl::Texture rays_, target_;
    gpu::gl::Framebuffer framebuffer_;
    gpu::gl::VertexArray vertexArray_;
    gpu::gl::Buffer indices_;
    GLsizei count_ = 0;
};

cv::Mat pinholeOf(const calib::Intrinsics& i) {
    return (cv::Mat_<double>(3, 3) << i.fx, 0, i.cx, 0, i.fy, i.cy, 0, 0, 1);
}

/// Metres by the library, rows top first.
std::vector<float> byLibrary(const calib::SensorRig& rig, const cv::Mat& depth, bool dilate) {
    const calib::Intrinsics& color = rig.color.intrinsics;
    const calib::Distortion& k = rig.color.distortion;
    const cv::Mat terms =
        (cv::Mat_<double>(1, 8) << k.k1, k.k2, k.p1, k.p2, k.k3, k.k4, k.k5, k.k6);
    cv::Mat pose = cv::Mat::eye(4, 4, CV_64F), registered;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            pose.at<double>(row, column) = rig.colorFromDepth.rotation[column][row];
        pose.at<double>(row, 3) = rig.colorFromDepth.translation[row];
    }
    cv::rgbd::registerDepth(pinholeOf(rig.depth.intrinsics), pinholeOf(color), terms, pose, depth,
                            cv::Size(color.width, color.height), registered, dilate);
    std::vector<float> metres;
    for (int y = 0; y < color.height; ++y)
        for (int x = 0; x < color.width; ++x)
            metres.push_back(static_cast<float>(registered.at<std::uint16_t>(y, x)) * 0.001F);
    return metres;
}

std::vector<float> read(const gpu::gl::Texture& texture) {
    std::vector<float> metres(static_cast<std::size_t>(texture.width()) *
                              static_cast<std::size_t>(texture.height()));
    glGetTextureImage(texture.name(), 0, GL_RED, GL_FLOAT,
                      static_cast<GLsizei>(metres.size() * sizeof(float)), metres.data());
    return metres;
}

/// Of all threads: on a software renderer that is the work, whoever else is busy.
double cpuMilliseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double milliseconds(const std::function<void()>& pass) {
    glFinish();
    const double start = cpuMilliseconds();
    pass();
    glFinish();
    return cpuMilliseconds() - start;
}

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return 0;
    const auto at = values.begin() +
                    static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

void report(const char* name, const std::vector<float>& metres,
            const std::vector<oracle::TruePixel>& truth, const std::vector<double>& times,
            double libraryMs, double plainMs) {
    std::vector<double> errors;
    std::size_t seen = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (!truth[i].seen) continue;
        ++seen;
        if (metres[i] > 0)
            errors.push_back(1000 * std::abs(static_cast<double>(metres[i]) - truth[i].z));
    }
    const double ms = quantile(times, 0.5);
    std::printf("| %-24s | %6.2f | %6.2f | %6.2f %% | %6.2f | %5.2f | %5.2f |\n", name,
                quantile(errors, 0.5), quantile(errors, 0.95),
                100 * static_cast<double>(errors.size()) / static_cast<double>(seen), ms,
                ms / libraryMs, ms / plainMs);
}

struct Size {
    int width, height;
};

/// The library knows no distortion of the depth camera: it has none here. The colour camera's is
/// of five terms, the scene the furnished room with a person, the counts noise-free.
void compare(Size depthSize, Size colorSize, std::size_t rounds) {
    calib::SensorRig rig = devices::sim::simulatedRig(depthSize.width, depthSize.height,
                                                      colorSize.width, colorSize.height);
    rig.depth.distortion = {};
    // A little aslant: no wall is at a whole number of millimetres all over the picture.
    const calib::RigidTransform sceneFromColor{
        glm::mat3_cast(glm::angleAxis(0.05, glm::normalize(glm::dvec3{1, 2, 0.5}))), {}};
    const auto scene = devices::sim::makeScene("person", 1);
    const auto now = scene->at(0);
    const auto counts = oracle::exactCounts(now, rig, sceneFromColor);
    const auto truth = oracle::truePixels(now, rig, sceneFromColor, 0);
    const gpu::gl::Texture depth(GL_R16UI, depthSize.width, depthSize.height);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(depth.name(), 0, 0, 0, depthSize.width, depthSize.height, GL_RED_INTEGER,
                        GL_UNSIGNED_SHORT, counts.data());
    cv::Mat picture(depthSize.height, depthSize.width, CV_16UC1);
    std::copy(counts.begin(), counts.end(), picture.begin<std::uint16_t>());

    gpu::DepthRegistration ours({}, {}, rig), bare({}, {0}, rig);
    PlainDraw plain(rig, colorSize.width, colorSize.height);
    std::vector<float> library, dilated;
    const std::array<std::function<void()>, 5> passes{
        [&] { ours.render(depth, kMillimetre, colorSize.width, colorSize.height); },
        [&] { bare.render(depth, kMillimetre, colorSize.width, colorSize.height); },
        [&] { library = byLibrary(rig, picture, false); },
        [&] { dilated = byLibrary(rig, picture, true); }, [&] { plain.render(depth); }};
    std::array<std::vector<double>, 5> times;
    constexpr std::size_t kWarmUp = 3;
    for (std::size_t round = 0; round < kWarmUp + rounds; ++round)
        for (std::size_t i = 0; i < passes.size(); ++i) {
            // Each comes first, second and so on equally often.
            const std::size_t which = (round + i) % passes.size();
            const double taken = milliseconds(passes.at(which));
            if (round >= kWarmUp) times.at(which).push_back(taken);
        }
    const double libraryMs = quantile(times[2], 0.5), plainMs = quantile(times[4], 0.5);
    std::printf("\n%dx%d -> %dx%d (drawing the grid once: %.2f ms)\n", depthSize.width,
                depthSize.height, colorSize.width, colorSize.height, plainMs);
    std::printf(
        "| error in mm, CPU ms      | median |  p95   | complete | ms     | / lib | /draw |\n");
    report("ours", read(ours.metres()), truth, times[0], libraryMs, plainMs);
    report("ours, not extruded", read(bare.metres()), truth, times[1], libraryMs, plainMs);
    report("registerDepth", library, truth, times[2], libraryMs, plainMs);
    report("registerDepth, dilated", dilated, truth, times[3], libraryMs, plainMs);
}

} // namespace

int main(int argc, char** argv) {
    const auto rounds = static_cast<std::size_t>(argc > 1 ? std::max(1, std::atoi(argv[1])) : 15);
    const gpu::gl::SurfacelessContext context(false);
    compare({640, 480}, {640, 480}, rounds);
    compare({640, 480}, {1280, 720}, rounds);
    compare({176, 144}, {640, 480}, rounds);
}
