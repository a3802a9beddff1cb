#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace autostereo::devices::kinect2 {

static_assert(std::endian::native == std::endian::little, "wire formats are read in place");

/// The T at `offset`, which the caller has checked to lie inside.
template<class T>
[[nodiscard]] T valueAt(std::span<const std::byte> bytes, std::size_t offset) {
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

/// Walks through packed fields whose total size the caller has checked.
class FieldReader {
  public:
    explicit FieldReader(std::span<const std::byte> bytes) : rest_(bytes) {}

    template<class T>
    [[nodiscard]] T next() {
        const T value = valueAt<T>(rest_, 0);
        rest_ = rest_.subspan(sizeof(T));
        return value;
    }
    /// Fills arrays of numbers, however nested.
    template<class Array>
    void fill(Array& array) {
        std::memcpy(&array, rest_.data(), sizeof array);
        rest_ = rest_.subspan(sizeof array);
    }
    [[nodiscard]] std::span<const std::byte> rest() const { return rest_; }

  private:
    std::span<const std::byte> rest_;
};

} // namespace autostereo::devices::kinect2
