#include "devices/tracking/trace_source.hpp"

namespace autostereo::devices {

std::optional<EyeSample> TraceSource::next(TimePoint now) {
    if (next_ == trace_.size()) return std::nullopt;
    const TracedEyes& traced = trace_[next_];
    if (start_ + traced.at > now) return std::nullopt;
    ++next_;
    return EyeSample{start_ + traced.at, traced.eyes};
}

} // namespace autostereo::devices
