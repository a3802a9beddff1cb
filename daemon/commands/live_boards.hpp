#pragma once

#include "daemon/commands/calibration_boards.hpp"

namespace autostereo::daemon {

/// Watches running cameras while somebody holds the board before them: takes views that are still,
/// sharp and unlike those before, says on the terminal and, where there is a display server, full
/// screen beside the colour picture what is wanted next. Ends with `views` of them and nothing more
/// wanted, with twice as many, at the input's end, at Escape or SIGINT. Throws as `findBoards`.
void watchBoards(const BoardOptions& options, const calibrate::Board& board, FoundBoards& found);

} // namespace autostereo::daemon
