#include "calib/light_field.hpp"

#include <algorithm>

namespace autostereo::calib {

namespace {

glm::vec2* rowOf(LightField& field, int y) { return &field.at(0, y); }

/// Mean over [x - left, x + right], row by row.
void blurRows(LightField& field, int left, int right) {
    if (left + right == 0) return;
    const double share = 1.0 / (left + right + 1);
    std::vector<glm::vec2> copy(static_cast<std::size_t>(field.width));
    for (int y = 0; y < field.height; ++y) {
        glm::vec2* row = rowOf(field, y);
        std::copy(row, row + field.width, copy.begin());
        const auto in = [&](int x) { return glm::dvec2(copy[static_cast<std::size_t>(x)]); };
        glm::dvec2 sum{0};
        for (int x = 0; x < std::min(right, field.width); ++x)
            sum += in(x);
        for (int x = 0; x < field.width; ++x) {
            if (x + right < field.width) sum += in(x + right);
            row[x] = glm::vec2(sum * share);
            if (x >= left) sum -= in(x - left);
        }
    }
}

/// Mean over [y - above, y + below], all columns side by side; from one field into the other.
void blurColumns(LightField& from, LightField& to, int above, int below) {
    const double share = 1.0 / (above + below + 1);
    std::vector<glm::dvec2> sums(static_cast<std::size_t>(from.width), glm::dvec2{0});
    const auto add = [&](int y, double sign) {
        const glm::vec2* row = rowOf(from, y);
        for (std::size_t x = 0; x < sums.size(); ++x)
            sums[x] += sign * glm::dvec2(row[x]);
    };
    for (int y = 0; y < std::min(below, from.height); ++y)
        add(y, 1);
    for (int y = 0; y < from.height; ++y) {
        if (y + below < from.height) add(y + below, 1);
        glm::vec2* row = rowOf(to, y);
        for (std::size_t x = 0; x < sums.size(); ++x)
            row[x] = glm::vec2(sums[x] * share);
        if (y >= above) add(y - above, -1);
    }
}

} // namespace

LightField::LightField(int fieldWidth, int fieldHeight)
    : width(fieldWidth), height(fieldHeight),
      values(static_cast<std::size_t>(fieldWidth) * static_cast<std::size_t>(fieldHeight),
             glm::vec2{0}) {}

void LightField::blur(int columns, int rows) {
    // Even widths lean to one side, then to the other.
    const int shorter = (columns - 1) / 2, longer = columns / 2;
    blurRows(*this, shorter, longer);
    blurRows(*this, longer, shorter);
    if (rows == 1) return;
    LightField other(width, height);
    blurColumns(*this, other, (rows - 1) / 2, rows / 2);
    blurColumns(other, *this, rows / 2, (rows - 1) / 2);
}

} // namespace autostereo::calib
