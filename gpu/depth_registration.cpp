#include "gpu/depth_registration.hpp"

#include "gpu/mesh_nodes.hpp"

#include <array>
#include <string>
#include <vector>

namespace autostereo::gpu {

namespace {

/// Head of shaders/cut_triangles.glsl: groups to dispatch, and how many there are.
constexpr std::array<GLuint, 4> kNoCuts{0, 1, 1, 0};

std::vector<std::string> cutDefines(const RegistrationParams& params) {
    if (params.extrudePx > 0) return {"EXTRUDE"};
    return {};
}

} // namespace

DepthRegistration::DepthRegistration(const DepthMeshParams& mesh, const RegistrationParams& params,
                                     const calib::SensorRig& rig)
    : mesh_(mesh), params_(params), rig_(rig), buildPlaces_({"mesh_points.comp"}, {"PLACES"}),
      drawMesh_({"register_mesh.comp"}), drawCuts_({"register_cuts.comp"}, cutDefines(params)) {
    block_.counts.w = static_cast<GLuint>(params.extrudePx);
}

void DepthRegistration::render(const gl::Texture& depth, double depthUnitM, int width, int height) {
    if (!counts_.isSized(depth.width() + 2 * frame(), depth.height() + 2 * frame()))
        resize(depth.width(), depth.height());
    glCopyImageSubData(depth.name(), GL_TEXTURE_2D, 0, 0, 0, 0, counts_.name(), GL_TEXTURE_2D, 0,
                       frame(), frame(), 0, depth.width(), depth.height(), 1);
    setCameras(block_, rig_, mesh_, depthUnitM);
    uniforms_.bind(0, block_);
    buildPlaces(buildPlaces_, places_, rays_, counts_);
    const std::array<const gl::Texture*, 2> grid{&places_, &rays_};
    registered_.clear(width, height);
    glNamedBufferSubData(cuts_.name(), 0, sizeof kNoCuts, kNoCuts.data());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, cuts_.name());
    registered_.drawMesh(drawMesh_, grid);
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT);
    registered_.drawCuts(drawCuts_, grid, cuts_);
    registered_.resolve();
}

void DepthRegistration::resize(int width, int height) {
    calib::CameraModel framed = rig_.depth.resized(width, height);
    framed.intrinsics.width += 2 * frame();
    framed.intrinsics.height += 2 * frame();
    framed.intrinsics.cx += frame();
    framed.intrinsics.cy += frame();
    rays_ = makeRays(framed);
    counts_ = gl::Texture(GL_R16UI, rays_.width(), rays_.height());
    glClearTexImage(counts_.name(), 0, GL_RED_INTEGER, GL_UNSIGNED_SHORT, nullptr);
    const auto triangles = 2 * static_cast<std::size_t>(rays_.width() - 1) *
                           static_cast<std::size_t>(rays_.height() - 1);
    cuts_ = gl::makeBuffer(sizeof kNoCuts + triangles * sizeof(GLuint), nullptr,
                           GL_DYNAMIC_STORAGE_BIT);
    places_ = gl::Texture(GL_RGBA32F, rays_.width(), rays_.height());
}

} // namespace autostereo::gpu
