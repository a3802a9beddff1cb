#include "devices/replay/jpeg_decoder.hpp"

#include <turbojpeg.h>

#include <stdexcept>
#include <string>

namespace autostereo::devices {

namespace {

const unsigned char* data(std::span<const std::byte> bytes) {
    return reinterpret_cast<const unsigned char*>(bytes.data());
}

} // namespace

void JpegDecoder::Close::operator()(void* handle) const noexcept { tjDestroy(handle); }

JpegDecoder::JpegDecoder() : handle_(tjInitDecompress()) {
    if (!handle_) throw std::runtime_error("cannot start the JPEG decoder");
}

void JpegDecoder::fail() const {
    throw std::runtime_error("JPEG " + header_.size().text() + ": " +
                             tjGetErrorStr2(handle_.get()));
}

ImageHeader JpegDecoder::open(std::span<const std::byte> bytes) {
    bytes_ = bytes;
    header_ = {};
    int subsampling = 0, colorspace = 0;
    if (tjDecompressHeader3(handle_.get(), data(bytes_), bytes_.size(), &header_.width,
                            &header_.height, &subsampling, &colorspace) != 0)
        fail();
    if (!header_.sizeAllowed())
        throw std::runtime_error("JPEG " + header_.size().text() + " (allowed 1 to 16384)");
    return header_;
}

void JpegDecoder::decode(std::span<std::byte> pixels) {
    if (pixels.size() < header_.bytes()) throw std::runtime_error("JPEG: buffer too small");
    // Limited scans: a progressive file of a few kilobytes may otherwise decode for minutes.
    constexpr int kStrict = TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS;
    if (tjDecompress2(handle_.get(), data(bytes_), bytes_.size(),
                      reinterpret_cast<unsigned char*>(pixels.data()), header_.width, 0,
                      header_.height, TJPF_RGBA, kStrict) != 0)
        fail();
}

} // namespace autostereo::devices
