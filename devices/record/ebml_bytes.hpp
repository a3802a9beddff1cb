#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <span>
#include <string_view>
#include <vector>

namespace autostereo::devices {

/// EBML elements put together in memory (RFC 8794). Sizes take eight bytes, so that they can be
/// overwritten in place. Value type.
class EbmlBytes {
  public:
    /// What stands for a size that is not known yet.
    static constexpr std::uint64_t kUnknownSize = 0x00ffffffffffffff;

    EbmlBytes& number(std::uint32_t id, std::uint64_t value) {
        head(id, sizeof value);
        return bigEndian(value, sizeof value);
    }
    EbmlBytes& real(std::uint32_t id, double value) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        return number(id, bits);
    }
    EbmlBytes& text(std::uint32_t id, std::string_view value) {
        return data(id, std::as_bytes(std::span(value)));
    }
    EbmlBytes& data(std::uint32_t id, std::span<const std::byte> value) {
        head(id, value.size());
        bytes_.insert(bytes_.end(), value.begin(), value.end());
        return *this;
    }
    EbmlBytes& group(std::uint32_t id, const EbmlBytes& children) {
        return data(id, children.bytes());
    }
    EbmlBytes& head(std::uint32_t id, std::uint64_t size) {
        std::size_t length = 4;
        while (length > 1 && id >> (8 * (length - 1)) == 0)
            --length;
        bigEndian(id, length);
        return bigEndian(size | 1ULL << 56, sizeof size);
    }

    [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }
    [[nodiscard]] std::size_t size() const { return bytes_.size(); }

  private:
    EbmlBytes& bigEndian(std::uint64_t value, std::size_t length) {
        for (std::size_t i = length; i-- > 0;)
            bytes_.push_back(static_cast<std::byte>(value >> (8 * i)));
        return *this;
    }

    std::vector<std::byte> bytes_;
};

} // namespace autostereo::devices
