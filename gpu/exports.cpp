#include "gpu/exports.hpp"

#include "gpu/depth_registration.hpp"
#include "gpu/views/disparity_view.hpp"
#include "gpu/views/layer_mesher.hpp"

#include <algorithm>
#include <cmath>

namespace autostereo::gpu {

namespace {

/// A picture of its own to draw mesh layers into.
struct Target {
    Target(GLenum format, int width, int height)
        : color(format, width, height), depth(GL_DEPTH_COMPONENT32F, width, height),
          framebuffer(gl::makeFramebuffer(color, &depth)) {}

    void clear(const std::array<double, 3>& clearColor) const {
        LayerDrawer::clear(framebuffer.name(), clearColor);
        glViewport(0, 0, color.width(), color.height());
    }
    gl::Texture color, depth;
    gl::Framebuffer framebuffer;
};

/// What a camera of its own kind sees of layers.
struct Shot {
    CyclopeanScene scene;
    const MeshBlock& mesh;
};

RgbImage renderColor(const Shot& shot, const PipelineParams& params, const gl::Program& program,
                     const EyeBlock& eye, const Target& target) {
    LayerDrawer drawer(params.mesh);
    LayerMesher mesher;
    gl::UniformBuffer<MeshBlock> mesh;
    gl::UniformBuffer<EyeBlock> uniforms;
    mesh.bind(0, shot.mesh);
    uniforms.bind(3, eye);
    const MeshLayers& layers = mesher.build(shot.scene);
    target.clear(params.clearColor);
    program.use();
    drawer.draw(layers, shot.scene.color, {1, 1, 0, 0}, 1);
    return readFramebuffer(target.framebuffer.name(), target.color.width(), target.color.height());
}

} // namespace

RgbImage renderEye(const Pipeline& pipeline, const PipelineParams& params,
                   const calib::DisplayProfile& display, glm::dvec3 eye, int width, int height) {
    const gl::Program program({"mesh_eye.vert", "mesh_view.frag"});
    const EyeBlock block = eyeBlock(display, eye, static_cast<double>(height) / width);
    return renderColor({pipeline.scene(), pipeline.mesh().block()}, params, program, block,
                       Target(GL_RGBA8, width, height));
}

MovedCamera::MovedCamera(const PipelineParams& params, const calib::SensorRig& rig,
                         glm::dvec3 offset)
    : params_(params), rig_(rig), offset_(offset), geometry_(movedCameraGeometry(rig, offset)),
      mesh_(params.mesh, rig), fusion_(params, rig),
      program_({"mesh_camera.vert", "mesh_view.frag"}, {"CUBIC"}) {}

RgbImage MovedCamera::render(const Pipeline& pipeline) {
    mesh_.build(pipeline.depth(), pipeline.mesh().block().budget.z, geometry_);
    fusion_.fuse(mesh_.layer(), pipeline.color(), geometry_);
    glEnable(GL_CLIP_DISTANCE0);
    RgbImage image =
        renderColor({fusion_.scene(pipeline.color()), mesh_.block()}, params_, program_,
                    {glm::dvec4(offset_, 0), {}},
                    Target(GL_RGBA8, rig_.color.intrinsics.width, rig_.color.intrinsics.height));
    glDisable(GL_CLIP_DISTANCE0);
    return image;
}

FloatImage renderDisparity(const Pipeline& pipeline, const PipelineParams& params,
                           const calib::DisplayProfile& display, int width, int height) {
    gl::UniformBuffer<MeshBlock> mesh;
    mesh.bind(0, pipeline.mesh().block());
    LayerMesher mesher;
    DisparityView view(params.mesh, width, height, display.disparityFar);
    view.render(mesher.build(pipeline.scene()), pipeline.color());
    FloatImage image{width, height, {}};
    image.values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(view.texture().name(), 0, GL_RED, GL_FLOAT,
                      static_cast<GLsizei>(image.values.size() * sizeof(float)),
                      image.values.data());
    flipRows(image.values, static_cast<std::size_t>(width));
    return image;
}

DepthImage renderRegisteredDepth(const gl::Texture& counts, double depthUnitM,
                                 const PipelineParams& params, const calib::SensorRig& rig) {
    const int width = rig.color.intrinsics.width, height = rig.color.intrinsics.height;
    DepthRegistration registration(params.mesh, params.registration, rig);
    registration.render(counts, depthUnitM, width, height);

    std::vector<float> metres(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    glGetTextureImage(registration.metres().name(), 0, GL_RED, GL_FLOAT,
                      static_cast<GLsizei>(metres.size() * sizeof(float)), metres.data());
    DepthImage image{width, height, {}};
    image.millimetres.reserve(metres.size());
    for (const float value : metres) {
        const long rounded = std::lround(std::clamp(value, 0.0F, 65.534F) * 1000);
        image.millimetres.push_back(static_cast<std::uint16_t>(rounded));
    }
    return image;
}

} // namespace autostereo::gpu
