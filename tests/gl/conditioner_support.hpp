#pragma once

#include "devices/sim/simulation.hpp"
#include "devices/sim/tof_sensor.hpp"
#include "gpu/depth_conditioner.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace autostereo::test {

/// One picture of a depth camera; amplitude may be empty.
struct DepthShot {
    int width = 0, height = 0;
    std::vector<std::uint16_t> counts, amplitude;

    [[nodiscard]] std::size_t at(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

/// Shots of a simulated scene, noisy or exact.
class Shots {
  public:
    explicit Shots(const std::string& uri) : input_(devices::sim::openSimulation(uri)) {}
    DepthShot next() {
        const auto frame = std::get<devices::Frame>(input_.depth->read(devices::TimePoint::max()));
        const auto depth = frame.depth(), amplitude = frame.amplitude();
        return {frame.metadata().width,
                frame.metadata().height,
                {depth.begin(), depth.end()},
                {amplitude.begin(), amplitude.end()}};
    }
    [[nodiscard]] const calib::CameraModel& camera() const { return input_.rig->depth; }

  private:
    devices::Input input_;
};

/// Runs shots through the GPU's conditioner and reads the clean counts.
class Conditioned {
  public:
    Conditioned(const gpu::ConditionParams& params, const calib::CameraModel& camera,
                const gpu::DepthMeshParams& range = {})
        : conditioner_(params, range, camera) {}

    std::vector<std::uint16_t> operator()(const DepthShot& shot, double unitM = 0.001) {
        const gpu::gl::Texture depth = upload(shot, shot.counts);
        if (shot.amplitude.empty()) {
            conditioner_.condition(depth, nullptr, unitM);
        } else {
            const gpu::gl::Texture amplitude = upload(shot, shot.amplitude);
            conditioner_.condition(depth, &amplitude, unitM);
        }
        std::vector<std::uint16_t> clean(shot.counts.size());
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glGetTextureImage(conditioner_.depth().name(), 0, GL_RED_INTEGER, GL_UNSIGNED_SHORT,
                          static_cast<GLsizei>(2 * clean.size()), clean.data());
        return clean;
    }
    [[nodiscard]] const gpu::DepthConditioner& pass() const { return conditioner_; }

  private:
    static gpu::gl::Texture upload(const DepthShot& shot,
                                   const std::vector<std::uint16_t>& counts) {
        gpu::gl::Texture texture(GL_R16UI, shot.width, shot.height);
        glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
        glTextureSubImage2D(texture.name(), 0, 0, 0, shot.width, shot.height, GL_RED_INTEGER,
                            GL_UNSIGNED_SHORT, counts.data());
        return texture;
    }
    gpu::DepthConditioner conditioner_;
};

} // namespace autostereo::test
