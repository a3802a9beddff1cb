#pragma once

#include "daemon/commands/calibration_boards.hpp"
#include "devices/frame.hpp"
#include "devices/replay/grey_image.hpp"

#include <optional>
#include <string>

namespace autostereo::daemon {

/// When a frame was taken, s of the host's clock.
[[nodiscard]] double stampOf(const devices::Frame& frame);

/// One camera's views of the board, as they come, into what was found. Both have to outlive it.
class BoardGatherer {
  public:
    BoardGatherer(const calibrate::Board& board, FoundBoards& found, bool isDepth);

    /// The board in a picture; none, which is noted. Throws DeviceError for a picture of another
    /// size than those before it.
    [[nodiscard]] std::optional<calibrate::BoardView> find(const devices::GreyPixels& picture,
                                                           const std::string& name);
    /// A view counts from here on; its place.
    std::size_t take(calibrate::BoardView view);
    /// The same of an input's colour frame, with its stamp.
    std::size_t take(calibrate::BoardView view, const devices::Frame& frame);
    /// Both.
    std::optional<std::size_t> look(const devices::GreyPixels& picture, const std::string& name);
    /// The board in a depth frame's amplitudes, with its depth and stamp; none without.
    std::optional<std::size_t> lookAtDepth(const devices::Frame& frame, const std::string& name);

  private:
    const calibrate::Board& board_;
    FoundBoards& found_;
    bool isDepth_;
    std::vector<calibrate::BoardView>& views_;
    int &width_, &height_;
};

} // namespace autostereo::daemon
