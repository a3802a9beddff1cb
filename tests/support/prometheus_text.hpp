#pragma once

#include <map>
#include <string>

namespace autostereo::test {

/// name{label="value",...} as written -> value.
using Samples = std::map<std::string, double>;

/// Prometheus' text format 0.0.4, read strictly: every family is one # HELP, one # TYPE, then its
/// samples; no family and no sample twice; names, labels, escapes and numbers as the format has
/// them; counters end in _total and are whole; histograms' buckets rise in bound and count, the
/// last is +Inf and equals _count. Throws std::runtime_error with the line.
[[nodiscard]] Samples prometheusSamples(const std::string& text);

} // namespace autostereo::test
