#pragma once

#include "calib/eye_pair.hpp"
#include "devices/clock.hpp"

#include <cstdint>
#include <optional>

namespace autostereo::devices {

/// Where a viewer's eyes were, and when.
struct EyeSample {
    TimePoint at;
    calib::EyePair eyes;
};

struct EyeCounters {
    std::uint64_t received = 0; ///< whatever came: accepted + damaged + limited
    std::uint64_t accepted = 0;
    std::uint64_t damaged = 0; ///< wrong size, no numbers, or nowhere a viewer can be
    std::uint64_t limited = 0; ///< good, but more than are of use; the newest won
};

/// Whether a viewer can be there: within 10 m each way, and no nearer to the panel than 10 cm.
[[nodiscard]] bool isPlausible(const calib::EyePair& eyes);
/// The plausible place next to each eye's own.
[[nodiscard]] calib::EyePair clamped(const calib::EyePair& eyes);

/// One viewer's eyes as they come in. `next` belongs to one thread and never blocks; what is not
/// taken in time is lost, oldest first.
class EyeSource {
  public:
    virtual ~EyeSource() = default;
    /// The oldest sample that was not given yet and was taken at `now` at the latest.
    [[nodiscard]] virtual std::optional<EyeSample> next(TimePoint now) = 0;
    /// Stamped on arrival; else recorded.
    [[nodiscard]] virtual bool isLive() const noexcept = 0;
    [[nodiscard]] virtual EyeCounters counters() const noexcept = 0;
};

} // namespace autostereo::devices
