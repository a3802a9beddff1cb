#pragma once

#include <glm/vec2.hpp>

#include <vector>

namespace autostereo::calib {

/// Light of one colour over the panel: x is its amount times its weight, y the weight, so that the
/// mean over any neighbourhood is sum x / sum y. Value type; reentrant.
struct LightField {
    LightField(int fieldWidth, int fieldHeight);

    int width;
    int height;
    std::vector<glm::vec2> values; ///< row by row from the top

    [[nodiscard]] glm::vec2& at(int x, int y) {
        return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                      static_cast<std::size_t>(x)];
    }
    /// Convolves with a tent, `columns` and `rows` wide at half its height; nothing lies outside.
    /// Two running means each way, in double precision: time does not depend on the width.
    void blur(int columns, int rows);
};

} // namespace autostereo::calib
