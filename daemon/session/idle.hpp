#pragma once

#include "daemon/session/idle_content.hpp"

#include <memory>
#include <string>

namespace autostereo::daemon {

/// What stands on the panel where there is nothing to show: words, else what [idle] content names.
/// A file that cannot be shown is said to the log and left out: a visitor then gets the plain
/// picture. Thread-bound.
class Idle {
  public:
    explicit Idle(const config::Config& config);

    /// Whether, without words, it looks otherwise from one moment to the next.
    [[nodiscard]] bool moves() const { return content_ && content_->moves(); }
    /// Whether that looks otherwise now than when it was drawn last.
    [[nodiscard]] bool advance(double seconds) { return content_ && content_->advance(seconds); }
    /// Another display, look or file.
    void replace(const config::Config& config);
    /// Throws GlError.
    void draw(const std::string& text, double seconds, const StandingTarget& target);
    /// Nobody sees it, or only words.
    void leave() {
        if (content_) content_->leave();
    }

  private:
    void open(const config::Config& config);
    void drawContent(double seconds, const StandingTarget& target);

    std::string file_;
    std::unique_ptr<IdleContent> content_; ///< none: a plain picture
};

} // namespace autostereo::daemon
