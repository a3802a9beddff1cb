#pragma once

#include <atomic>
#include <cstdint>

namespace autostereo::gpu::gl {

/// What the owning wrappers of objects.hpp hold at the moment, in all contexts of the process.
struct Usage {
    std::int64_t objects = 0; ///< names of any kind
    std::int64_t bytes = 0;   ///< storage of textures and buffers, as the driver states its formats

    [[nodiscard]] bool operator==(const Usage&) const = default;
};

namespace detail {
inline std::atomic<std::int64_t> objectsAlive{0};
inline std::atomic<std::int64_t> bytesAlive{0};
} // namespace detail

[[nodiscard]] inline Usage usage() { return {detail::objectsAlive, detail::bytesAlive}; }

} // namespace autostereo::gpu::gl
