#include "devices/kinect2/raw/raw_reader.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace autostereo::devices::kinect2 {

namespace {

bool fill(std::istream& file, void* to, std::size_t bytes) {
    file.read(static_cast<char*>(to), static_cast<std::streamsize>(bytes));
    return static_cast<std::size_t>(file.gcount()) == bytes;
}

std::string textOf(const std::vector<std::byte>& bytes) {
    constexpr std::size_t kMost = 64;
    std::string text;
    for (const std::byte byte : std::span(bytes).first(std::min(bytes.size(), kMost))) {
        const auto letter = std::to_integer<char>(byte);
        text += letter >= ' ' && letter <= '~' ? letter : '?';
    }
    return text;
}

} // namespace

RawReader::RawReader(std::unique_ptr<std::istream> file) : file_(std::move(file)) {
    std::array<char, kRawMagic.size()> magic{};
    isRecording_ = fill(*file_, magic.data(), magic.size()) && magic == kRawMagic;
}

bool RawReader::next(RawRecord& record) {
    if (!isRecording_ || damaged_ || !fill(*file_, &record.header, sizeof record.header))
        return false;
    damaged_ = record.header.payloadBytes > kMostRawPayload;
    if (damaged_) return false;
    record.payload.resize(record.header.payloadBytes);
    if (!fill(*file_, record.payload.data(), record.payload.size())) return false;
    damaged_ = checksumOf(record.header, record.payload) != record.header.checksum;
    return !damaged_;
}

std::optional<UnitPages> RawReader::pages(const RawRecord& start) {
    UnitPages pages;
    pages.serial = textOf(start.payload);
    RawRecord record;
    const auto read = [&](RawKind kind) { return next(record) && record.header.kind == kind; };
    if (!read(RawKind::Firmware)) return std::nullopt;
    pages.firmware = textOf(record.payload);
    for (const auto& [kind, page] :
         {std::pair{RawKind::PhasePage, &pages.phases}, std::pair{RawKind::DepthPage, &pages.depth},
          std::pair{RawKind::ColorPage, &pages.color}}) {
        if (!read(kind)) return std::nullopt;
        *page = std::move(record.payload);
    }
    return pages;
}

} // namespace autostereo::devices::kinect2
