#include "tests/device/uvc/jpeg_picture.hpp"

#include <turbojpeg.h>

#include <memory>
#include <stdexcept>

namespace autostereo::test {

usbip::Bytes jpegPicture(int width, int height, unsigned seed) {
    usbip::Bytes rgb;
    rgb.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const int value : {x / 2 + y / 3, x ^ y, (x * y) >> 7})
                usbip::put8(rgb, static_cast<unsigned>(value) + 5 * seed);
    struct Close {
        void operator()(void* handle) const { tjDestroy(handle); }
    };
    const std::unique_ptr<void, Close> encoder(tjInitCompress());
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    constexpr int kQuality = 60;
    if (!encoder || tjCompress2(encoder.get(), rgb.data(), width, 0, height, TJPF_RGB, &bytes,
                                &size, TJSAMP_422, kQuality, 0) != 0)
        throw std::runtime_error("cannot make a JPEG");
    const usbip::Bytes jpeg(bytes, bytes + size);
    tjFree(bytes);
    return jpeg;
}

} // namespace autostereo::test
