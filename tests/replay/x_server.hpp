#pragma once

#include "tests/replay/pictures.hpp"
#include "tests/support/run_program.hpp"

#include <optional>
#include <string>
#include <vector>

namespace autostereo::test {

/// A virtual X server with one monitor of this size, 24 bits, on a free display number. Destruction
/// ends it. Throws std::runtime_error when it doesn't come up. Thread-bound.
class XServer {
  public:
    XServer(int width, int height);

    /// For DISPLAY.
    [[nodiscard]] std::string display() const { return ":" + number_; }
    /// The whole screen as it is now.
    [[nodiscard]] ColorPicture screenshot() const;

    /// Keys of the keyboard, by X's names, one after the other. Throws std::runtime_error.
    void press(const std::vector<std::string>& keys) const;
    /// Seconds without input until the screen saver comes; 0: never.
    [[nodiscard]] int screenSaverTimeout() const;
    /// The pointer's picture has at least one pixel that is not transparent.
    [[nodiscard]] bool pointerVisible() const;

    /// What is missing to start one here, or nothing.
    [[nodiscard]] static std::optional<std::string> missing();

  private:
    RunningProgram server_;
    std::string number_;
};

} // namespace autostereo::test
