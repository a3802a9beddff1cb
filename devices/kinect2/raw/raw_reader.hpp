#pragma once

#include "devices/kinect2/raw/raw_record.hpp"
#include "devices/kinect2/unit_facts.hpp"

#include <istream>
#include <memory>
#include <optional>

namespace autostereo::devices::kinect2 {

/// Reads a recording record by record; takes any bytes, memory is bounded. A part of a record at
/// the end is an end, as a killed writer leaves it; one whose checksum is wrong is damage, and an
/// end too. Thread-bound.
class RawReader {
  public:
    /// Nothing is read where the format's name is not there.
    explicit RawReader(std::unique_ptr<std::istream> file);

    [[nodiscard]] bool isRecording() const { return isRecording_; }
    /// False: that was all.
    [[nodiscard]] bool next(RawRecord& record);
    [[nodiscard]] bool damaged() const { return damaged_; }
    /// The unit whose Start was read last; nothing where the file ends or other records come
    /// before all of its pages did.
    [[nodiscard]] std::optional<UnitPages> pages(const RawRecord& start);

  private:
    std::unique_ptr<std::istream> file_;
    bool isRecording_ = false;
    bool damaged_ = false;
};

} // namespace autostereo::devices::kinect2
