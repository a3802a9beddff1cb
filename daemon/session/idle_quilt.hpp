#pragma once

#include "daemon/quilt_file.hpp"
#include "daemon/session/idle_content.hpp"

namespace autostereo::daemon {

/// A quilt as `interleave` shows it. Thread-bound.
class IdleQuilt final : public IdleContent {
  public:
    explicit IdleQuilt(const std::filesystem::path& file) : quilt_(readQuilt(file)) {}

    void draw(double seconds, const StandingTarget& target) override;

  private:
    Quilt quilt_;
};

} // namespace autostereo::daemon
