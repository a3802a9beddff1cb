#include "gpu/mesh_nodes.hpp"

#include "gpu/gl/dispatch.hpp"
#include "gpu/scene_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace autostereo::gpu {

gl::Texture makeRays(const calib::CameraModel& camera) {
    constexpr float kNoRay = 1e30F; // shaders/mesh_block.glsl tests for less
    const int width = camera.intrinsics.width, height = camera.intrinsics.height;
    std::vector<glm::vec2> rays;
    rays.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            rays.emplace_back(camera.unproject({x, y}).value_or(glm::dvec2(kNoRay)));
    gl::Texture texture(GL_RG32F, width, height);
    glTextureSubImage2D(texture.name(), 0, 0, 0, width, height, GL_RG, GL_FLOAT, rays.data());
    return texture;
}

void setCameras(MeshBlock& block, const calib::SensorRig& rig, const DepthMeshParams& params,
                double depthUnitM) {
    const calib::Intrinsics& pinhole = rig.color.intrinsics;
    const calib::Distortion& bend = rig.color.distortion;
    const CountRange range = countRange(params, depthUnitM);
    glm::dmat4 pose(rig.colorFromDepth.rotation);
    pose[3] = glm::dvec4(rig.colorFromDepth.translation, 1);
    block.colorFromDepth = pose;
    block.colorPinhole = glm::dvec4(pinhole.fx, pinhole.fy, pinhole.cx, pinhole.cy);
    // Squared, it must stay finite in float.
    const double radius = std::min(bend.metricRadius, 1e9);
    block.colorSize = glm::dvec4(pinhole.width, pinhole.height, radius * radius, 0);
    block.colorRadial = glm::dvec4(bend.k1, bend.k2, bend.k3, bend.p1);
    block.colorRational = glm::dvec4(bend.k4, bend.k5, bend.k6, bend.p2);
    block.budget.z = static_cast<float>(depthUnitM);
    block.counts.x = range.nearest;
    block.counts.y = range.farthest;
    block.counts.z = static_cast<unsigned>(std::lround(params.cutRatio * 1000));
}

void buildNodes(const gl::Program& program, const MeshLayer& layer, const gl::Texture& rays,
                const gl::Texture& nodes, const BlockList& list) {
    glBindTextureUnit(0, rays.name());
    glBindTextureUnit(1, nodes.name());
    glBindImageTexture(0, layer.points.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    glBindImageTexture(1, layer.sources.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32F);
    list.dispatch(program);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void buildPlaces(const gl::Program& program, const gl::Texture& places, const gl::Texture& rays,
                 const gl::Texture& counts) {
    glBindTextureUnit(0, rays.name());
    glBindTextureUnit(1, counts.name());
    glBindImageTexture(0, places.name(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    gl::dispatch(program, places.width(), places.height());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

} // namespace autostereo::gpu
