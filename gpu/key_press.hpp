#pragma once

namespace autostereo::gpu {

/// A key of the panel's keyboard that went down, or is held.
struct KeyPress {
    enum class Key { Left, Right, Up, Down, PageUp, PageDown, Letter };
    Key key = Key::Letter;
    char letter = 0; ///< lower case, as the keyboard's layout has it

    friend bool operator==(const KeyPress&, const KeyPress&) = default;
};

} // namespace autostereo::gpu
