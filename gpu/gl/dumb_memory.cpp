#include "gpu/gl/dumb_memory.hpp"

#include "gpu/gl/error.hpp"

#include <fcntl.h>
#include <xf86drm.h>

#include <cerrno>
#include <cstring>

namespace autostereo::gpu::gl {

namespace {

[[noreturn]] void fail(const std::string& tried, const std::string& node, int error) {
    throw GlError("drm: cannot " + tried + " " + node + ": " + std::strerror(error));
}

} // namespace

DumbMemory::DumbMemory(const std::string& cardNode)
    : node_(cardNode), card_(::open(cardNode.c_str(), O_RDWR | O_CLOEXEC)) {
    if (!card_) fail("open", node_, errno); // whether it gives any, cards without outputs don't say
}

devices::UniqueFd DumbMemory::allocate(std::size_t rowBytes, std::size_t rows) {
    constexpr std::size_t kMostSide = 65536;
    if (rowBytes == 0 || rows == 0 || rowBytes > kMostSide || rows > kMostSide)
        fail("get buffers of", node_, EINVAL);
    drm_mode_create_dumb made{};
    made.width = static_cast<std::uint32_t>(rowBytes);
    made.height = static_cast<std::uint32_t>(rows);
    made.bpp = 8;
    if (drmIoctl(card_.get(), DRM_IOCTL_MODE_CREATE_DUMB, &made) != 0)
        fail("get buffers of", node_, errno);
    int fd = -1;
    const int error =
        drmPrimeHandleToFD(card_.get(), made.handle, DRM_CLOEXEC | DRM_RDWR, &fd) == 0 ? 0 : errno;
    devices::UniqueFd shared(fd);
    // The descriptor keeps the memory.
    drm_mode_destroy_dumb handle{made.handle};
    drmIoctl(card_.get(), DRM_IOCTL_MODE_DESTROY_DUMB, &handle);
    if (error != 0) fail("share buffers of", node_, error);
    if (made.pitch != rowBytes)
        throw GlError("drm: " + node_ + " wants rows of " + std::to_string(made.pitch) +
                      " bytes, not " + std::to_string(rowBytes));
    return shared;
}

} // namespace autostereo::gpu::gl
