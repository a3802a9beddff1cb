#pragma once

#include "devices/unique_fd.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace autostereo::devices {

/// The head of one EBML element; positions in bytes from the start of the file.
struct EbmlHead {
    std::uint32_t id = 0;
    std::uint64_t begin = 0; ///< of its data
    std::uint64_t end = 0;   ///< never beyond the limit that it was read with
    bool whole = false;      ///< false: it claims to end beyond that limit, or not to know its end

    [[nodiscard]] std::uint64_t size() const { return end - begin; }
};

/// Heads and plain values of an EBML file, read where they are asked for. Never looks for the
/// next good element by itself and never reads an element's children, so that damage stays where
/// it is. Sizes are checked before anything is allocated. Thread-bound; opening throws
/// DeviceError, reading gives nothing where there is nothing.
class EbmlFile {
  public:
    explicit EbmlFile(const std::filesystem::path& path);
    ~EbmlFile();
    EbmlFile(const EbmlFile&) = delete;
    EbmlFile& operator=(const EbmlFile&) = delete;

    [[nodiscard]] std::uint64_t size() const;
    /// The element whose head is exactly at `at`.
    [[nodiscard]] std::optional<EbmlHead> headAt(std::uint64_t at, std::uint64_t limit);
    /// Where the four bytes of `id` stand at or behind `from`, else size().
    [[nodiscard]] std::uint64_t find(std::uint32_t id, std::uint64_t from);
    /// All of `to`, or false.
    [[nodiscard]] bool readAt(std::uint64_t at, std::span<std::byte> to) const;

    /// Empty where the element has more than `limit` bytes.
    [[nodiscard]] std::vector<std::byte> bytes(const EbmlHead& element, std::size_t limit) const;
    [[nodiscard]] std::string text(const EbmlHead& element) const;
    [[nodiscard]] std::uint64_t number(const EbmlHead& element) const;

    /// Calls `visit` for every whole child, up to the first damaged one.
    template<class Visit>
    void forEachChild(const EbmlHead& parent, const Visit& visit) {
        std::uint64_t at = parent.begin;
        while (const auto child = headAt(at, parent.end)) {
            if (child->whole) visit(*child);
            at = child->end;
        }
    }

  private:
    class Stream;
    std::unique_ptr<Stream> stream_;
};

} // namespace autostereo::devices
