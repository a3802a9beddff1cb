#include "tests/bench/views/contender.hpp"

#include "gpu/gl/usage.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace autostereo::bench {

namespace {

double processCpuMs() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double gpuMemoryMib() { return static_cast<double>(gpu::gl::usage().bytes) / (1024 * 1024); }

/// GPU time between two points, by time stamps.
class GpuSpan {
  public:
    GpuSpan() {
        glGenQueries(2, names_);
        glQueryCounter(names_[0], GL_TIMESTAMP);
    }
    ~GpuSpan() { glDeleteQueries(2, names_); }
    GpuSpan(const GpuSpan&) = delete;
    GpuSpan& operator=(const GpuSpan&) = delete;
    double endMs() {
        glQueryCounter(names_[1], GL_TIMESTAMP);
        GLuint64 begun = 0, ended = 0;
        glGetQueryObjectui64v(names_[0], GL_QUERY_RESULT, &begun);
        glGetQueryObjectui64v(names_[1], GL_QUERY_RESULT, &ended);
        return 1e-6 * static_cast<double>(ended - begun);
    }

  private:
    GLuint names_[2]{};
};

} // namespace

Contender::Contender(std::string name, const FusedInput& input,
                     const gpu::SynthesisParams& synthesis, const calib::DisplayProfile& display,
                     int width, int height, Part part)
    : name_(std::move(name)), input_(input), synthesis_(synthesis), part_(part),
      target_(GL_RGBA8, width, height), panel_(gpu::gl::makeFramebuffer(target_)) {
    const double before = gpuMemoryMib();
    gpu::PipelineParams params = input.params;
    params.synthesis = synthesis;
    views_ = gpu::makeViewSynthesis(params, display, width, height);
    input_.use();
    views_->prepare(input_.pipeline->scene()); // textures get their sizes
    memoryMib_ = gpuMemoryMib() - before;
}

void Contender::round(bool counts) {
    const gpu::CyclopeanScene scene = input_.pipeline->scene();
    input_.use();
    if (part_ == Part::Show) views_->prepare(scene);
    glFinish();
    const double cpuBegan = processCpuMs();
    const auto began = std::chrono::steady_clock::now();
    GpuSpan span;
    if (part_ == Part::All) views_->prepare(scene);
    views_->show(scene, panel_.name());
    const double gpuMs = span.endMs();
    glFinish();
    const std::chrono::duration<double, std::milli> wall = std::chrono::steady_clock::now() - began;
    if (!counts) return;
    cpu_.push_back(processCpuMs() - cpuBegan);
    wall_.push_back(wall.count());
    gpu_.push_back(gpuMs);
}

double Contender::wallMs() const { return median(wall_); }
double Contender::cpuMs() const { return median(cpu_); }
double Contender::gpuMs() const { return median(gpu_); }

gpu::RgbImage Contender::picture() const {
    return gpu::readFramebuffer(panel_.name(), target_.width(), target_.height());
}

} // namespace autostereo::bench
