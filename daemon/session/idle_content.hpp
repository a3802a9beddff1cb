#pragma once

#include "calib/picture.hpp"
#include "config/config.hpp"
#include "daemon/session/standing_target.hpp"

#include <memory>

namespace autostereo::daemon {

/// What [idle] content names: shown where there is nothing else to show and nothing to say. One
/// class a kind of file. Constructors read the file, as far as that tells whether it can be shown,
/// and throw what its readers throw; none needs a GL context. Thread-bound.
class IdleContent {
  public:
    virtual ~IdleContent() = default;
    /// Whether it looks otherwise from one moment to the next; else it is drawn once and kept.
    [[nodiscard]] virtual bool moves() const { return false; }
    /// Whether it looks otherwise now than when it was drawn last; `seconds` since the start.
    [[nodiscard]] virtual bool advance(double /*seconds*/) { return false; }
    /// As it is at that moment. Throws DeviceError, UsageError, GlError.
    virtual void draw(double seconds, const StandingTarget& target) = 0;
    /// What words are written before; empty: a plain picture.
    [[nodiscard]] virtual const calib::Picture& background() const;
    /// Another display, or another look; the same file.
    virtual void replace(const config::Config& /*config*/) {}
    /// Nobody sees it: what only drawing it takes (threads, GPU memory) goes.
    virtual void leave() {}
};

/// None where the configuration names none. Throws what the readers throw.
[[nodiscard]] std::unique_ptr<IdleContent> openIdleContent(const config::Config& config);

} // namespace autostereo::daemon
