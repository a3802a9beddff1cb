#include "devices/v4l2/capture_buffers.hpp"

#include "devices/input.hpp"

#include <fcntl.h>
#include <linux/dma-buf.h>
#include <linux/videodev2.h>
#include <sys/ioctl.h>
#include <sys/mman.h>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace autostereo::devices::v4l2 {

namespace {

constexpr std::uint32_t kOwnBuffers = 4;
/// The driver's share, and what a queue and the pairing hold at their fullest, pictures that are
/// drawn, shown and being read: where fewer are left the newest, which are shown, would be copies.
constexpr std::uint32_t kLentBuffers = 16;

v4l2_buffer bufferRequest(std::uint32_t memory, std::uint32_t index) {
    v4l2_buffer buffer{};
    buffer.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    buffer.memory = memory;
    buffer.index = index;
    return buffer;
}

/// How many the driver gives.
std::uint32_t requestBuffers(const VideoNode& node, std::uint32_t memory, std::uint32_t count) {
    v4l2_requestbuffers request{};
    request.count = count;
    request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    request.memory = memory;
    if (const int error = node.control(VIDIOC_REQBUFS, request))
        node.fail("get buffers of", "VIDIOC_REQBUFS", error);
    return std::min<std::uint32_t>(request.count, VIDEO_MAX_FRAME);
}

UniqueFd exportBuffer(const VideoNode& node, std::uint32_t index) {
    v4l2_exportbuffer request{};
    request.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    request.index = index;
    request.flags = O_CLOEXEC | O_RDWR;
    if (const int error = node.control(VIDIOC_EXPBUF, request))
        node.fail("share buffers of", "VIDIOC_EXPBUF", error);
    return UniqueFd(request.fd);
}

std::uint64_t nextSet() {
    static std::atomic<std::uint64_t> last{0};
    return ++last;
}

} // namespace

CaptureBuffers::Mapping::Mapping(int fd, std::size_t length, std::int64_t offset) {
    void* data = ::mmap(nullptr, length, PROT_READ, MAP_SHARED, fd, offset);
    if (data == MAP_FAILED) return;
    data_ = static_cast<std::byte*>(data);
    length_ = length;
}

CaptureBuffers::Mapping::~Mapping() {
    if (data_ != nullptr) ::munmap(data_, length_);
}

/// Gives the buffer back when its last holder is gone.
struct CaptureBuffers::Lease : SharedPixels {
    explicit Lease(std::shared_ptr<CaptureBuffers> lender) : buffers(std::move(lender)) {}
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    ~Lease() { buffers->release(index); }
    std::shared_ptr<CaptureBuffers> buffers;
};

CaptureBuffers::CaptureBuffers(std::uint32_t memory) : memory_(memory), set_(nextSet()) {}
CaptureBuffers::~CaptureBuffers() = default;

std::shared_ptr<CaptureBuffers> CaptureBuffers::drivers(const VideoNode& node, bool exported) {
    std::shared_ptr<CaptureBuffers> made(new CaptureBuffers(V4L2_MEMORY_MMAP));
    const std::uint32_t count =
        requestBuffers(node, made->memory_, exported ? kLentBuffers : kOwnBuffers);
    for (std::uint32_t i = 0; i < count; ++i) {
        v4l2_buffer about = bufferRequest(made->memory_, i);
        if (const int error = node.control(VIDIOC_QUERYBUF, about))
            node.fail("get buffers of", "VIDIOC_QUERYBUF", error);
        auto buffer = std::make_unique<Buffer>();
        buffer->mapping =
            std::make_unique<Mapping>(node.fd(), about.length, std::int64_t{about.m.offset});
        if (buffer->mapping->bytes().empty()) node.fail("map buffers of", "mmap", errno);
        if (exported) buffer->dmabuf = exportBuffer(node, i);
        made->all_.push_back(std::move(buffer));
    }
    return made;
}

std::shared_ptr<CaptureBuffers> CaptureBuffers::filled(const VideoNode& node, PixelMemory& memory,
                                                       const BufferShape& shape) {
    // Drivers may want more than the rows take, but what some say is absurd.
    constexpr std::size_t kMostRows = 4;
    const std::size_t rows =
        std::max(shape.rows, (shape.pictureBytes + shape.rowBytes - 1) / shape.rowBytes);
    if (rows > kMostRows * shape.rows)
        throw DeviceError("v4l2: " + node.path() + " wants " + std::to_string(shape.pictureBytes) +
                          " bytes a picture");
    std::shared_ptr<CaptureBuffers> made(new CaptureBuffers(V4L2_MEMORY_DMABUF));
    const std::uint32_t count = requestBuffers(node, made->memory_, kLentBuffers);
    for (std::uint32_t i = 0; i < count; ++i) {
        auto buffer = std::make_unique<Buffer>();
        buffer->dmabuf = memory.allocate(shape.rowBytes, rows);
        buffer->mapping = std::make_unique<Mapping>(buffer->dmabuf.get(), shape.rowBytes * rows, 0);
        if (buffer->mapping->bytes().empty()) node.fail("map the GPU's buffers for", "mmap", errno);
        made->all_.push_back(std::move(buffer));
    }
    return made;
}

std::span<const std::byte> CaptureBuffers::bytes(std::uint32_t index) const {
    return all_[index]->mapping->bytes();
}

/// Before the host reads what a device wrote into the GPU's memory, and after.
void CaptureBuffers::synchronise(const Buffer& buffer, bool begin) const {
    if (memory_ != V4L2_MEMORY_DMABUF) return;
    dma_buf_sync request{};
    request.flags = DMA_BUF_SYNC_READ;
    request.flags |= begin ? DMA_BUF_SYNC_START : DMA_BUF_SYNC_END;
    int result = 0;
    do {
        result = ::ioctl(buffer.dmabuf.get(), DMA_BUF_IOCTL_SYNC, &request);
    } while (result < 0 && (errno == EINTR || errno == EAGAIN));
}

int CaptureBuffers::queue(const VideoNode& node, std::uint32_t index) {
    Buffer& buffer = *all_[index];
    v4l2_buffer request = bufferRequest(memory_, index);
    if (memory_ == V4L2_MEMORY_DMABUF) request.m.fd = buffer.dmabuf.get();
    const int error = node.control(VIDIOC_QBUF, request);
    buffer.queued = error == 0;
    return error;
}

void CaptureBuffers::queueFree(const VideoNode& node) {
    for (std::uint32_t i = 0; i < count(); ++i)
        if (!all_[i]->queued && !all_[i]->taken.load(std::memory_order_acquire))
            static_cast<void>(queue(node, i));
}

std::uint32_t CaptureBuffers::queued() const {
    return static_cast<std::uint32_t>(
        std::ranges::count_if(all_, [](const auto& buffer) { return buffer->queued; }));
}

void CaptureBuffers::take(std::uint32_t index) {
    Buffer& buffer = *all_[index];
    buffer.queued = false;
    buffer.taken.store(true, std::memory_order_relaxed);
    synchronise(buffer, true);
}

void CaptureBuffers::release(std::uint32_t index) {
    Buffer& buffer = *all_[index];
    synchronise(buffer, false);
    buffer.taken.store(false, std::memory_order_release);
}

std::shared_ptr<const SharedPixels> CaptureBuffers::lend(std::uint32_t index,
                                                         std::shared_ptr<PixelSharing> sharing,
                                                         PixelWay way, std::size_t rowBytes) {
    auto lease = std::make_shared<Lease>(shared_from_this());
    lease->sharing = std::move(sharing);
    lease->way = way;
    lease->fd = all_[index]->dmabuf.get();
    lease->set = set_;
    lease->index = index;
    lease->rowBytes = rowBytes;
    return lease;
}

} // namespace autostereo::devices::v4l2
