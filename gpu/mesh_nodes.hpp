#pragma once

#include "calib/sensor_rig.hpp"
#include "gpu/blocks.hpp"
#include "gpu/dirty/block_list.hpp"
#include "gpu/gl/program.hpp"
#include "gpu/mesh_layer.hpp"
#include "gpu/params.hpp"

namespace autostereo::gpu {

/// Direction (x/z, y/z) of each pixel of a camera, RG32F; beyond shaders/mesh_block.glsl's kNoRay
/// where it has none.
[[nodiscard]] gl::Texture makeRays(const calib::CameraModel& camera);

/// Fills in the colour camera, where it stands, and which counts are measurements.
void setCameras(MeshBlock& block, const calib::SensorRig& rig, const DepthMeshParams& params,
                double depthUnitM);

/// Fills `layer`'s points and sources, those of `list`. `program`: a variant of mesh_points.comp;
/// `nodes`: counts, as large as the layer. The mesh block is bound by the caller.
void buildNodes(const gl::Program& program, const MeshLayer& layer, const gl::Texture& rays,
                const gl::Texture& nodes, const BlockList& list);
/// The same for the registration: RGBA32F texture coordinate in the colour image, z, count.
void buildPlaces(const gl::Program& program, const gl::Texture& places, const gl::Texture& rays,
                 const gl::Texture& counts);

} // namespace autostereo::gpu
