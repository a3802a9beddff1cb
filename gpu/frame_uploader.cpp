#include "gpu/frame_uploader.hpp"

#include <algorithm>
#include <cstring>
#include <vector>

namespace autostereo::gpu {

FrameUploader::Staging::~Staging() {
    if (fence_ != nullptr) glDeleteSync(fence_);
}

void FrameUploader::Staging::reserve(std::size_t bytes) {
    if (bytes <= capacity_) return;
    constexpr GLbitfield kMapping = GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
    buffer_ = gl::makeBuffer(bytes, nullptr, kMapping);
    mapped_ = static_cast<std::byte*>(
        glMapNamedBufferRange(buffer_.name(), 0, static_cast<GLsizeiptr>(bytes), kMapping));
    capacity_ = bytes;
}

void FrameUploader::Staging::copy(std::span<const std::byte> pixels, const gl::Texture& to,
                                  GLenum format, GLenum type) {
    if (fence_ != nullptr) {
        constexpr GLuint64 kForever = 1'000'000'000; // a GPU that takes a second has other trouble
        glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, kForever);
        glDeleteSync(fence_);
    }
    reserve(pixels.size());
    std::memcpy(mapped_, pixels.data(), pixels.size());
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer_.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(to.name(), 0, 0, 0, to.width(), to.height(), format, type, nullptr);
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

void FrameUploader::upload(const devices::RgbdFrame& frame) {
    const devices::FrameMetadata& depth = frame.depth.metadata();
    if (!depth_.isSized(depth.width, depth.height))
        depth_ = gl::Texture(GL_R16UI, depth.width, depth.height);
    if (depth.hasAmplitude && !amplitude_.isSized(depth.width, depth.height))
        amplitude_ = gl::Texture(GL_R16UI, depth.width, depth.height);
    ring_[next_].copy(frame.depth.pixels(), depth_, GL_RED_INTEGER, GL_UNSIGNED_SHORT);
    uploadColor(frame.color);
    hasAmplitude_ = depth.hasAmplitude;
    if (hasAmplitude_)
        ring_[next_ + 2].copy(std::as_bytes(frame.depth.amplitude()), amplitude_, GL_RED_INTEGER,
                              GL_UNSIGNED_SHORT);
    next_ = (next_ + kPlanes) % ring_.size();
}

void FrameUploader::fitColor(const devices::FrameMetadata& form) {
    if (color_.isSized(form.width, form.height)) return;
    colorMarks_.resize(form.width, form.height);
    color_ = gl::Texture(GL_RGBA8, form.width, form.height);
    color_.setFilter(GL_LINEAR);
}

bool FrameUploader::importColor(const devices::Frame& frame) {
    const devices::FrameMetadata& form = frame.metadata();
    const bool wanted = imports_ && ColorConverter::converts(form.format);
    const GLuint bytes = import_.bytesOf(frame, wanted);
    if (bytes == 0) return false;
    const bool isFirst = !color_.isSized(form.width, form.height);
    fitColor(form);
    colorMarks_.clear();
    converter_.convert(form, bytes, color_, &colorMarks_);
    if (isFirst) colorMarks_.markAll(); // nothing was there before
    import_.readBy(frame);
    hold_.forget(); // it has not seen this one
    colorChanged_ = true;
    return true;
}

void FrameUploader::uploadColor(const devices::Frame& frame) {
    if (importColor(frame)) return;
    const devices::FrameMetadata& form = frame.metadata();
    colorChanged_ = hold_.update(frame);
    if (!colorChanged_) return;
    fitColor(form);
    uploadMarks(form);
    Staging& staging = ring_[next_ + 1];
    if (!ColorConverter::converts(form.format)) {
        const GLenum order = form.format == devices::PixelFormat::Bgra8 ? GL_BGRA : GL_RGBA;
        staging.copy(hold_.bytes(), color_, order, GL_UNSIGNED_BYTE);
        return;
    }
    const auto [columns, rows] = ColorConverter::byteGrid(form);
    if (!colorBytes_.isSized(columns, rows)) colorBytes_ = gl::Texture(GL_R8, columns, rows);
    staging.copy(hold_.bytes(), colorBytes_, GL_RED, GL_UNSIGNED_BYTE);
    converter_.convert(form, colorBytes_.name(), color_);
}

void FrameUploader::uploadMarks(const devices::FrameMetadata& form) {
    const int across = BlockMarks::blocksOf(form.width), down = BlockMarks::blocksOf(form.height);
    std::vector<std::uint8_t> marks = hold_.renewed();
    const bool sharesChroma = ColorConverter::sharesChroma(form.format);
    for (int i = 0; sharesChroma && i < across * down;
         ++i) { // interpolated from one block to the next
        const int x = i % across, y = i / across;
        for (int v = std::max(y - 1, 0); v <= std::min(y + 1, down - 1); ++v)
            for (int u = std::max(x - 1, 0); u <= std::min(x + 1, across - 1); ++u)
                marks[static_cast<std::size_t>(i)] |=
                    hold_.renewed()[static_cast<std::size_t>(v) * static_cast<std::size_t>(across) +
                                    static_cast<std::size_t>(u)];
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(colorMarks_.texture().name(), 0, 0, 0, across, down, GL_RED_INTEGER,
                        GL_UNSIGNED_BYTE, marks.data());
}

} // namespace autostereo::gpu
