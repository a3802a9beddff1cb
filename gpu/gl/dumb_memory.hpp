#pragma once

#include "devices/pixel_sharing.hpp"

#include <string>

namespace autostereo::gpu::gl {

/// Linear buffers of a graphics card, as its kernel driver gives them to any program that may open
/// its node ("dumb" buffers): no library of the card's is needed.
class DumbMemory final : public devices::PixelMemory {
  public:
    /// Throws GlError: no such card, no permission.
    explicit DumbMemory(const std::string& cardNode);
    [[nodiscard]] devices::UniqueFd allocate(std::size_t rowBytes, std::size_t rows) override;

  private:
    std::string node_;
    devices::UniqueFd card_;
};

} // namespace autostereo::gpu::gl
