#include "devices/replay/ebml_file.hpp"

#include "devices/input.hpp"

#include <ebml/EbmlElement.h>
#include <ebml/IOCallback.h>
#include <matroska/KaxCluster.h>
#include <matroska/KaxSegment.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <limits>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>

namespace autostereo::devices {

/// The file as libebml wants to see it: a pointer that moves, with a small buffer, since heads are
/// read byte by byte.
class EbmlFile::Stream final : public libebml::IOCallback {
  public:
    explicit Stream(const std::filesystem::path& path)
        : fd_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {
        struct stat status {};
        if (!fd_ || ::fstat(fd_.get(), &status) != 0)
            throw DeviceError("cannot open " + path.string() + ": " +
                                  std::generic_category().message(errno),
                              errno == ENOENT);
        if (!S_ISREG(status.st_mode)) throw DeviceError(path.string() + ": not a file");
        size_ = static_cast<std::uint64_t>(status.st_size);
    }

    [[nodiscard]] std::uint64_t size() const { return size_; }

    [[nodiscard]] bool readAt(std::uint64_t at, std::span<std::byte> to) const {
        while (!to.empty()) {
            const auto got = ::pread(fd_.get(), to.data(), to.size(), static_cast<off_t>(at));
            if (got < 0 && errno == EINTR) continue;
            if (got <= 0) return false;
            at += static_cast<std::uint64_t>(got);
            to = to.subspan(static_cast<std::size_t>(got));
        }
        return true;
    }

    std::uint32_t read(void* to, std::size_t count) override {
        auto* out = static_cast<std::byte*>(to);
        // The library looks at bytes that it asked for even where it is told that there are none.
        std::fill_n(out, count, std::byte{0});
        std::size_t done = 0;
        for (; done < count && available(); ++done, ++position_)
            out[done] = current();
        return static_cast<std::uint32_t>(done);
    }
    void setFilePointer(std::int64_t offset, libebml::seek_mode mode) override {
        const std::uint64_t base = mode == libebml::seek_beginning ? 0
                                   : mode == libebml::seek_end     ? size_
                                                                   : position_;
        position_ = base + static_cast<std::uint64_t>(offset);
    }
    std::uint64_t getFilePointer() override { return position_; }
    std::size_t write(const void* /*from*/, std::size_t /*count*/) override { return 0; }
    void close() override {}

    /// Through the same buffer as the heads, so that going back and forth costs no reading.
    [[nodiscard]] std::uint64_t find(std::uint32_t id, std::uint64_t from) {
        const std::array wanted{
            static_cast<unsigned char>(id >> 24U), static_cast<unsigned char>(id >> 16U),
            static_cast<unsigned char>(id >> 8U), static_cast<unsigned char>(id)};
        position_ = from;
        while (available()) {
            const std::byte* here = buffer_.data() + (position_ - bufferedAt_);
            const std::byte* end = buffer_.data() + buffered_;
            const void* hit = std::memchr(here, wanted[0], static_cast<std::size_t>(end - here));
            const auto* first = hit == nullptr ? end : static_cast<const std::byte*>(hit);
            position_ += static_cast<std::uint64_t>(first - here);
            const std::uint64_t candidate = position_;
            std::array<unsigned char, wanted.size()> found{};
            if (hit == nullptr) continue;
            if (read(found.data(), found.size()) == found.size() && found == wanted)
                return candidate;
            position_ = candidate + 1;
        }
        return size_;
    }

  private:
    /// Has the buffer hold the byte at position_; false at the end.
    [[nodiscard]] bool available() {
        if (position_ >= bufferedAt_ && position_ - bufferedAt_ < buffered_) return true;
        if (position_ >= size_) return false;
        bufferedAt_ = position_;
        buffered_ =
            static_cast<std::size_t>(std::min<std::uint64_t>(buffer_.size(), size_ - position_));
        if (readAt(bufferedAt_, std::span(buffer_).first(buffered_))) return true;
        buffered_ = 0;
        return false;
    }
    [[nodiscard]] std::byte current() const {
        return buffer_[static_cast<std::size_t>(position_ - bufferedAt_)];
    }

    UniqueFd fd_;
    std::uint64_t size_ = 0;
    std::uint64_t position_ = 0;
    std::array<std::byte, 4096> buffer_{};
    std::uint64_t bufferedAt_ = 0;
    std::size_t buffered_ = 0;
};

EbmlFile::EbmlFile(const std::filesystem::path& path) : stream_(std::make_unique<Stream>(path)) {}
EbmlFile::~EbmlFile() = default;

std::uint64_t EbmlFile::size() const { return stream_->size(); }

std::optional<EbmlHead> EbmlFile::headAt(std::uint64_t at, std::uint64_t limit) {
    if (at >= limit) return std::nullopt;
    // Only the kind that is asked for may have an unknown size: in recordings these two do.
    using Kinds = std::array<const libebml::EbmlCallbacks*, 2>;
    for (const auto* kind :
         Kinds{&EBML_INFO(libmatroska::KaxCluster), &EBML_INFO(libmatroska::KaxSegment)}) {
        stream_->setFilePointer(static_cast<std::int64_t>(at), libebml::seek_beginning);
        const std::unique_ptr<libebml::EbmlElement> head(libebml::EbmlElement::FindNextID(
            *stream_, *kind, std::numeric_limits<std::int64_t>::max()));
        const std::uint64_t begin = stream_->getFilePointer();
        if (!head || begin > limit) continue;
        const bool whole = head->IsFiniteSize() && head->GetSize() <= limit - begin;
        return EbmlHead{libebml::EbmlId(*head).GetValue(), begin,
                        whole ? begin + head->GetSize() : limit, whole};
    }
    return std::nullopt;
}

std::uint64_t EbmlFile::find(std::uint32_t id, std::uint64_t from) {
    return stream_->find(id, from);
}

bool EbmlFile::readAt(std::uint64_t at, std::span<std::byte> to) const {
    return stream_->readAt(at, to);
}

std::vector<std::byte> EbmlFile::bytes(const EbmlHead& element, std::size_t limit) const {
    std::vector<std::byte> bytes(element.size() <= limit ? element.size() : 0);
    if (!readAt(element.begin, bytes)) bytes.clear();
    return bytes;
}

std::string EbmlFile::text(const EbmlHead& element) const {
    constexpr std::size_t kLongest = 64U << 10U;
    const auto found = bytes(element, kLongest);
    std::string text;
    std::transform(found.begin(), std::find(found.begin(), found.end(), std::byte{0}),
                   std::back_inserter(text), [](std::byte b) { return static_cast<char>(b); });
    return text;
}

std::uint64_t EbmlFile::number(const EbmlHead& element) const {
    std::uint64_t number = 0;
    for (const std::byte b : bytes(element, sizeof number))
        number = number << 8U | std::to_integer<std::uint64_t>(b);
    return number;
}

} // namespace autostereo::devices
