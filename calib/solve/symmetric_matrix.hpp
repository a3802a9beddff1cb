#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace autostereo::calibrate {

/// Dense and symmetric, for normal equations and covariances of a few hundred parameters. Rows and
/// columns are scaled to a unit diagonal before anything is factored, because the parameters'
/// units differ by orders of magnitude. Value type; reentrant.
class SymmetricMatrix {
  public:
    SymmetricMatrix() = default;
    explicit SymmetricMatrix(std::size_t size) : size_(size), values_(size * size) {}

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] double at(std::size_t row, std::size_t column) const {
        return values_[row * size_ + column];
    }
    /// Both triangles are kept: set both, or the lower one and call `mirror`.
    [[nodiscard]] double& at(std::size_t row, std::size_t column) {
        return values_[row * size_ + column];
    }
    void mirror();
    void scale(double factor);
    [[nodiscard]] SymmetricMatrix block(std::size_t first, std::size_t count) const;

    /// x of (A + damping diag(A)) x = right; none where that is not positive definite.
    [[nodiscard]] std::optional<std::vector<double>> solved(std::span<const double> right,
                                                            double damping) const;
    [[nodiscard]] std::optional<SymmetricMatrix> inverse() const;
    /// Largest / smallest eigenvalue once the diagonal is 1: of a covariance, how far its
    /// parameters can be told apart (1: wholly; from 1e6 on hardly). Infinite where an eigenvalue
    /// is not positive.
    [[nodiscard]] double conditionOfCorrelation() const;

  private:
    /// 1 / sqrt(diagonal); empty where an element is not positive.
    [[nodiscard]] std::vector<double> scales() const;
    [[nodiscard]] SymmetricMatrix scaled(std::span<const double> scales) const;

    std::size_t size_ = 0;
    std::vector<double> values_;
};

} // namespace autostereo::calibrate
