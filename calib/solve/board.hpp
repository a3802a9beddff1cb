#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace autostereo::calibrate {

/// Markers in the white squares of a ChArUco board: a dictionary of OpenCV's aruco module.
struct Markers {
    int bits = 4;        ///< of a side: 4, 5, 6 or 7
    int count = 50;      ///< in the dictionary: 50, 100, 250 or 1000
    double share = 0.75; ///< side of a marker / side of a square
};

/// A flat board of squares. Frame: origin at the first inner corner, x along the rows, y down the
/// columns, metres. Value type.
struct Board {
    int columns = 0; ///< inner corners along x
    int rows = 0;
    double squareM = 0;
    std::optional<Markers> markers; ///< none: a chessboard, of which all corners have to be seen

    [[nodiscard]] int corners() const { return columns * rows; }
    [[nodiscard]] glm::dvec3 corner(int id) const {
        const int column = id % columns, row = id / columns;
        return {squareM * column, squareM * row, 0};
    }
};

/// The corners of a board that one picture shows.
struct BoardView {
    std::string name; ///< of the picture, for messages
    std::vector<int> ids;
    std::vector<glm::dvec2> pixels; ///< as many; the centre of the first pixel is (0, 0)

    [[nodiscard]] std::size_t size() const { return ids.size(); }
};

} // namespace autostereo::calibrate
