#pragma once

#include "gpu/pipeline.hpp"
#include "gpu/readback.hpp"

#include <memory>
#include <string>
#include <vector>

namespace autostereo::bench {

/// A scene fused once, at one density, for any number of contenders.
struct FusedInput {
    gpu::PipelineParams params;
    std::unique_ptr<gpu::Pipeline> pipeline;
    mutable gpu::gl::UniformBuffer<gpu::MeshBlock> mesh;

    void use() const { mesh.bind(0, pipeline->mesh().block()); }
};

/// A method with the scene that it draws, its target, and what it took so far.
class Contender {
  public:
    /// `part`: only filling the panel is timed (Part::Show), or both halves.
    enum class Part { All, Show };
    Contender(std::string name, const FusedInput& input, const gpu::SynthesisParams& synthesis,
              const calib::DisplayProfile& display, int width, int height, Part part);

    void round(bool counts);

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] const gpu::SynthesisParams& synthesis() const { return synthesis_; }
    [[nodiscard]] double wallMs() const;
    [[nodiscard]] double cpuMs() const;
    [[nodiscard]] double gpuMs() const;
    [[nodiscard]] double memoryMib() const { return memoryMib_; }
    [[nodiscard]] bool isWhole() const { return part_ == Part::All; }
    [[nodiscard]] gpu::RgbImage picture() const;

  private:
    std::string name_;
    const FusedInput& input_;
    gpu::SynthesisParams synthesis_;
    Part part_;
    gpu::gl::Texture target_;
    gpu::gl::Framebuffer panel_;
    std::unique_ptr<gpu::ViewSynthesis> views_;
    double memoryMib_ = 0;
    std::vector<double> wall_, cpu_, gpu_;
};

} // namespace autostereo::bench
