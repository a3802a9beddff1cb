#include "gpu/color_import.hpp"

#include "gpu/color_converter.hpp"
#include "gpu/gl/dumb_memory.hpp"
#include "gpu/gl/error.hpp"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace autostereo::gpu {

namespace {

using devices::PixelWay;

void answer(devices::PixelSharing& sharing) {
    if (const auto problem = gl::importProblem()) return sharing.decline(*problem);
    // Software drivers name no card, though they can import what one has.
    std::string node = gl::cardNode();
    if (node.empty()) node = "/dev/dri/card0";
    std::shared_ptr<devices::PixelMemory> memory;
    try {
        memory = std::make_shared<gl::DumbMemory>(node);
    } catch (const GlError& error) {
        spdlog::info("color: no memory for cameras to fill: {}", error.what());
    }
    sharing.offer(std::move(memory));
}

} // namespace

ColorImport::~ColorImport() {
    if (fence_ != nullptr) glDeleteSync(fence_);
}

void ColorImport::letGo() {
    if (fence_ == nullptr) return;
    constexpr GLuint64 kForever = 1'000'000'000; // a GPU that takes a second has other trouble
    glClientWaitSync(fence_, GL_SYNC_FLUSH_COMMANDS_BIT, kForever);
    glDeleteSync(fence_);
    fence_ = nullptr;
    held_.reset();
}

void ColorImport::readBy(const devices::Frame& frame) {
    held_ = frame.shared();
    fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
}

GLuint ColorImport::bytesOf(const devices::Frame& frame, bool wanted) {
    letGo();
    way_ = PixelWay::Copied;
    const auto& shared = frame.shared();
    if (!shared) return 0;
    if (!wanted) {
        constexpr const char* kWhy = "the host has to see them";
        shared->sharing->decline(kWhy);
        shared->sharing->refuse(shared->way, kWhy); // another configuration wanted them
        return 0;
    }
    if (!shared->sharing->answered()) answer(*shared->sharing);
    if (shared->fd < 0) return 0;
    try {
        const GLuint texture = imported(frame);
        if (verdict_ == Verdict::Unknown) verdict_ = compare(texture, frame);
        if (verdict_ == Verdict::Different) throw GlError("the GPU reads other bytes there");
        if (verdict_ == Verdict::Unknown) return 0;
        way_ = shared->way;
        return texture;
    } catch (const GlError& error) {
        shared->sharing->refuse(shared->way, error.what());
        imports_.clear();
        return 0;
    }
}

GLuint ColorImport::imported(const devices::Frame& frame) {
    const devices::SharedPixels& shared = *frame.shared();
    if (shared.set != set_) {
        imports_.clear();
        set_ = shared.set;
        verdict_ = Verdict::Unknown;
    }
    const auto known = imports_.find(shared.index);
    if (known != imports_.end()) return known->second.name();
    const auto [columns, rows] = ColorConverter::byteGrid(frame.metadata());
    return imports_.emplace(shared.index, gl::ByteImport(shared.fd, columns, rows))
        .first->second.name();
}

/// Unknown where all bytes are the same: so is memory that the GPU cannot read.
ColorImport::Verdict ColorImport::compare(GLuint texture, const devices::Frame& frame) const {
    constexpr int kRowsRead = 16;
    const auto [columns, rows] = ColorConverter::byteGrid(frame.metadata());
    const auto rowBytes = static_cast<std::size_t>(columns);
    std::vector<std::byte> read(rowBytes);
    bool varies = false;
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    for (int i = 0; i < kRowsRead; ++i) {
        const int row = i * (rows - 1) / (kRowsRead - 1);
        glGetTextureSubImage(texture, 0, 0, row, 0, columns, 1, 1, GL_RED, GL_UNSIGNED_BYTE,
                             static_cast<GLsizei>(rowBytes), read.data());
        const auto seen =
            frame.pixels().subspan(static_cast<std::size_t>(row) * rowBytes, rowBytes);
        if (std::memcmp(read.data(), seen.data(), rowBytes) != 0) return Verdict::Different;
        varies |= std::ranges::any_of(seen, [&](std::byte b) { return b != frame.pixels()[0]; });
    }
    return varies ? Verdict::Same : Verdict::Unknown;
}

} // namespace autostereo::gpu
