#include "devices/replay/jpeg_mirror.hpp"

#include <turbojpeg.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace autostereo::devices {

namespace {

struct Close {
    void operator()(void* handle) const noexcept { tjDestroy(handle); }
};
struct Free {
    void operator()(unsigned char* bytes) const noexcept { tjFree(bytes); }
};

} // namespace

std::vector<std::byte> mirroredJpeg(std::span<const std::byte> jpeg) {
    const std::unique_ptr<void, Close> handle(tjInitTransform());
    if (!handle) throw std::runtime_error("cannot start the JPEG transformer");
    tjtransform flip{};
    flip.op = TJXOP_HFLIP;
    flip.options = TJXOPT_PERFECT;
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    const int status =
        tjTransform(handle.get(), reinterpret_cast<const unsigned char*>(jpeg.data()), jpeg.size(),
                    1, &bytes, &size, &flip, TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS);
    const std::unique_ptr<unsigned char, Free> owner(bytes);
    if (status != 0)
        throw std::runtime_error(std::string("JPEG: cannot be mirrored: ") +
                                 tjGetErrorStr2(handle.get()));
    const auto all = std::as_bytes(std::span(bytes, size));
    return {all.begin(), all.end()};
}

} // namespace autostereo::devices
