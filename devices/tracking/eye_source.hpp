#pragma once

#include "calib/eye_pair.hpp"
#include "calib/sensor_rig.hpp"
#include "devices/clock.hpp"
#include "devices/frame.hpp"

#include <cstdint>
#include <optional>

namespace autostereo::devices {

/// Where a viewer's eyes were, and when.
struct EyeSample {
    TimePoint at;
    calib::EyePair eyes;
};

struct EyeCounters {
    std::uint64_t received = 0; ///< whatever came: the sum of the others
    std::uint64_t accepted = 0;
    std::uint64_t damaged = 0; ///< wrong size, no numbers, or nowhere a viewer can be
    std::uint64_t limited = 0; ///< more than are of use, or than there was time for; the newest won
    std::uint64_t nobody = 0;  ///< pictures without a viewer
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
    /// The daemon's own cameras, and what they see, for sources that look there.
    virtual void useCameras(const calib::SensorRig& /*rig*/) {}
    virtual void saw(const RgbdFrame& /*frame*/) {}
};

} // namespace autostereo::devices
