#pragma once

#include <cstdint>
#include <string>

namespace autostereo::devices {

/// A recording of what a device sends below its decoder, under way. Thread-safe.
class RawRecording {
  public:
    struct Counters {
        std::uint64_t written = 0, leftOut = 0; ///< packets; left out where the disk is too slow
        std::uint64_t bytes = 0;                ///< of the file
        std::string error;                      ///< why it ended; "": it goes on
    };
    virtual ~RawRecording() = default;
    /// Writes what it still holds; nothing more is taken.
    virtual void finish() = 0;
    [[nodiscard]] virtual Counters counters() const = 0;
};

} // namespace autostereo::devices
