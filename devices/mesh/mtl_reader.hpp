#pragma once

#include "devices/mesh/readers.hpp"

#include <map>

namespace autostereo::devices::mesh {

/// The materials of an MTL file, added to the scene: Kd, Ks, Ke (as on a screen, so sRGB), Ns,
/// map_Kd. Names to indices; a later one of a name counts. What is wrong in it is repaired.
void readMtl(const MeshFile& file, const std::string& name, MeshScene& scene,
             std::map<std::string, int, std::less<>>& materials);

} // namespace autostereo::devices::mesh
