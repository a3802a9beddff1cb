#include "calib/solve/symmetric_matrix.hpp"

#include <opencv2/core.hpp>

#include <cmath>
#include <limits>

namespace autostereo::calibrate {

void SymmetricMatrix::mirror() {
    for (std::size_t row = 0; row < size_; ++row)
        for (std::size_t column = row + 1; column < size_; ++column)
            at(row, column) = at(column, row);
}

void SymmetricMatrix::scale(double factor) {
    for (double& value : values_)
        value *= factor;
}

SymmetricMatrix SymmetricMatrix::block(std::size_t first, std::size_t count) const {
    SymmetricMatrix part(count);
    for (std::size_t row = 0; row < count; ++row)
        for (std::size_t column = 0; column < count; ++column)
            part.at(row, column) = at(first + row, first + column);
    return part;
}

std::vector<double> SymmetricMatrix::scales() const {
    std::vector<double> result(size_);
    for (std::size_t i = 0; i < size_; ++i) {
        const double value = at(i, i);
        if (!(value > 0) || !std::isfinite(value)) return {};
        result[i] = 1 / std::sqrt(value);
    }
    return result;
}

SymmetricMatrix SymmetricMatrix::scaled(std::span<const double> scales) const {
    SymmetricMatrix result(size_);
    for (std::size_t row = 0; row < size_; ++row)
        for (std::size_t column = 0; column < size_; ++column)
            result.at(row, column) = at(row, column) * scales[row] * scales[column];
    return result;
}

std::optional<std::vector<double>> SymmetricMatrix::solved(std::span<const double> right,
                                                           double damping) const {
    const auto unit = scales();
    if (unit.size() != size_ || right.size() != size_) return std::nullopt;
    SymmetricMatrix work = scaled(unit);
    std::vector<double> x(size_), scaledRight(size_);
    for (std::size_t i = 0; i < size_; ++i) {
        work.at(i, i) += damping;
        scaledRight[i] = right[i] * unit[i];
    }
    const auto n = static_cast<int>(size_);
    const cv::Mat left(n, n, CV_64F, work.values_.data());
    const cv::Mat given(n, 1, CV_64F, scaledRight.data());
    cv::Mat found(n, 1, CV_64F, x.data());
    if (!cv::solve(left, given, found, cv::DECOMP_CHOLESKY)) return std::nullopt;
    for (std::size_t i = 0; i < size_; ++i)
        x[i] *= unit[i];
    return x;
}

std::optional<SymmetricMatrix> SymmetricMatrix::inverse() const {
    const auto unit = scales();
    if (unit.size() != size_) return std::nullopt;
    SymmetricMatrix work = scaled(unit), result(size_);
    const auto n = static_cast<int>(size_);
    const cv::Mat left(n, n, CV_64F, work.values_.data());
    cv::Mat found(n, n, CV_64F, result.values_.data());
    if (cv::invert(left, found, cv::DECOMP_CHOLESKY) == 0) return std::nullopt;
    return result.scaled(unit);
}

double SymmetricMatrix::conditionOfCorrelation() const {
    constexpr double kWorst = std::numeric_limits<double>::infinity();
    const auto unit = scales();
    if (unit.size() != size_ || size_ == 0) return kWorst;
    SymmetricMatrix work = scaled(unit);
    const auto n = static_cast<int>(size_);
    const cv::Mat matrix(n, n, CV_64F, work.values_.data());
    cv::Mat values; // falling
    cv::eigen(matrix, values);
    const double least = values.at<double>(n - 1);
    return least > 0 ? values.at<double>(0) / least : kWorst;
}

} // namespace autostereo::calibrate
