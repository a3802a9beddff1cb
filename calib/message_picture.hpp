#pragma once

#include "calib/picture.hpp"

#include <string_view>

namespace autostereo::calib {

/// What a panel of this size shows when there is nothing live: the background, fitted in with its
/// shape kept (or a plain dark one, where there is none), and words in the middle that can be read
/// from where the panel can be seen: as large as fits half of its height and four fifths of its
/// width. Letters as in glyphs.hpp; words go to the next line where they don't fit. Reentrant.
[[nodiscard]] Picture messagePicture(const Picture& background, std::string_view text, int width,
                                     int height);

} // namespace autostereo::calib
