#pragma once

#include "devices/mesh/gltf_json.hpp"
#include "devices/mesh/readers.hpp"

#include <span>
#include <vector>

namespace autostereo::devices::mesh {

/// Numbers of one accessor, `components` apiece, as floats: normalised whole numbers become shares.
struct GltfValues {
    std::size_t count = 0;
    std::size_t components = 0;
    std::vector<float> values;
};

/// The bytes behind a glTF document: its binary chunk, files beside it, `data:` addresses. Views
/// and accessors are checked against what is there before anything is copied. Throws DeviceError.
class GltfBuffers {
  public:
    GltfBuffers(const MeshFile& file, const Json& document, std::span<const std::byte> chunk);

    /// Bytes of buffer view number `index`.
    [[nodiscard]] std::span<const std::byte> view(std::size_t index) const;
    /// Values of accessor number `index`, at most `most` of them.
    [[nodiscard]] GltfValues values(std::size_t index, std::size_t most) const;
    /// The same as whole numbers.
    [[nodiscard]] std::vector<std::uint32_t> indices(std::size_t index, std::size_t most) const;
    /// What an address holds: a file in the folder, or the data in it.
    [[nodiscard]] std::vector<std::byte> fetch(const std::string& uri) const;

  private:
    struct Elements;
    [[nodiscard]] Elements elements(std::size_t index, std::size_t most) const;

    const MeshFile& file_;
    const Json& document_;
    std::vector<std::vector<std::byte>> owned_;
    std::vector<std::span<const std::byte>> buffers_;
};

} // namespace autostereo::devices::mesh
