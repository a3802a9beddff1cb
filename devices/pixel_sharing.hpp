#pragma once

#include "devices/unique_fd.hpp"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

namespace autostereo::devices {

/// How a camera's pictures come to the GPU, in the order in which it is tried.
enum class PixelWay : std::uint8_t {
    Filled,   ///< the driver writes into memory of the GPU's
    Exported, ///< the GPU reads the driver's own memory
    Copied,   ///< through frames of ours, uploaded
};
[[nodiscard]] const char* pixelWayName(PixelWay way); ///< "filled", ...

/// Where memory comes from that the GPU reads and drivers of other devices can write. Any thread.
class PixelMemory {
  public:
    virtual ~PixelMemory() = default;
    /// A dmabuf of so many rows, each `rowBytes` after the one before. Throws std::runtime_error.
    [[nodiscard]] virtual UniqueFd allocate(std::size_t rowBytes, std::size_t rows) = 0;
};

/// What a camera and the one who shows its pictures have agreed upon, whichever of them finds that
/// a way does not work. Copied until somebody offers better; refusals are for good and are logged,
/// a line each. Any thread.
class PixelSharing {
  public:
    [[nodiscard]] PixelWay way() const { return way_.load(std::memory_order_acquire); }
    /// Whether who shows them has offered or declined.
    [[nodiscard]] bool answered() const { return answered_.load(std::memory_order_acquire); }

    /// By who shows them: no copy is needed. No memory: only what is the driver's own.
    void offer(std::shared_ptr<PixelMemory> memory);
    /// By who shows them: they have to be copied.
    void decline(const std::string& why);
    /// That way does not work; the next one is in use then.
    void refuse(PixelWay way, const std::string& why);
    /// What was offered.
    [[nodiscard]] std::shared_ptr<PixelMemory> memory() const;

  private:
    std::atomic<PixelWay> way_{PixelWay::Copied};
    std::atomic<bool> answered_{false};
    mutable std::mutex mutex_;
    std::shared_ptr<PixelMemory> memory_;
};

/// One picture where the driver left it, as the GPU can import it. Whoever holds this keeps the
/// driver from writing there again; the memory outlives the camera. In frames that were copied:
/// without a descriptor, whom to tell that they need not be.
struct SharedPixels {
    std::shared_ptr<PixelSharing> sharing;
    PixelWay way = PixelWay::Copied;
    int fd = -1;             ///< dmabuf of `rowBytes` times the rows, valid as long as this
    std::uint64_t set = 0;   ///< of buffers that were made together, never the same again
    std::uint32_t index = 0; ///< of the buffer in its set
    std::size_t rowBytes = 0;
};

} // namespace autostereo::devices
