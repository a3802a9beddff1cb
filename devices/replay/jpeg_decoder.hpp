#pragma once

#include "devices/replay/image.hpp"

#include <memory>
#include <span>

namespace autostereo::devices {

/// JPEG in memory -> Rgba8. open() keeps a view of the bytes until decode(). Anything the library
/// warns about (a premature end, bad codes) is an error: half a picture is no picture.
/// Reusable, thread-bound; throws std::runtime_error.
class JpegDecoder {
  public:
    JpegDecoder();
    [[nodiscard]] ImageHeader open(std::span<const std::byte> bytes);
    void decode(std::span<std::byte> pixels);

  private:
    struct Close {
        void operator()(void* handle) const noexcept;
    };
    [[noreturn]] void fail() const;

    std::unique_ptr<void, Close> handle_;
    std::span<const std::byte> bytes_;
    ImageHeader header_;
};

} // namespace autostereo::devices
