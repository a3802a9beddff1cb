#pragma once

#include "daemon/session/idle_content.hpp"

#include <filesystem>

namespace autostereo::daemon {

/// A picture, fitted into the panel's plane; words are written before it. Thread-bound.
class IdlePicture final : public IdleContent {
  public:
    explicit IdlePicture(const std::filesystem::path& file);

    void draw(double seconds, const StandingTarget& target) override;
    [[nodiscard]] const calib::Picture& background() const override { return picture_; }

  private:
    calib::Picture picture_;
};

} // namespace autostereo::daemon
