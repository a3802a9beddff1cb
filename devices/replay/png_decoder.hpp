#pragma once

#include "devices/replay/image.hpp"

#include <memory>
#include <span>

namespace autostereo::devices {

/// PNG in memory -> Grey16 (16-bit grey) or Rgba8 (all else; alpha becomes 255). open() keeps a
/// view of the bytes until decode(). A missing end is an error. Thread-bound; throws
/// std::runtime_error.
class PngDecoder {
  public:
    PngDecoder();
    ~PngDecoder();
    PngDecoder(const PngDecoder&) = delete;
    PngDecoder& operator=(const PngDecoder&) = delete;

    [[nodiscard]] ImageHeader open(std::span<const std::byte> bytes);
    void decode(std::span<std::byte> pixels);

    [[nodiscard]] static bool recognises(std::span<const std::byte> bytes);

  private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace autostereo::devices
