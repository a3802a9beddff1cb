#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace autostereo::devices {

/// The last good calibration of each display, so that a display that serves none (Looking Glass do
/// so until they are plugged in again) keeps working. Files are replaced whole: after a crash or a
/// power cut there is the old text or the new one. Reentrant; two processes may share a folder.
class CalibrationCache {
  public:
    static constexpr std::size_t kMostBytes = 1U << 20U;

    /// `folder` need not exist; it is made when something is stored.
    explicit CalibrationCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

    /// Nothing where there is none, or none that can be read.
    [[nodiscard]] std::optional<std::string> load(std::string_view serial) const;
    /// Nothing, or why it could not be kept, one sentence: a warning, never the end.
    [[nodiscard]] std::optional<std::string> store(std::string_view serial,
                                                   std::string_view text) const;

    /// "LKG-P00000.json"; letters other than A-Z a-z 0-9 become dashes, at most 64. Nothing for a
    /// serial without a letter or digit.
    [[nodiscard]] static std::optional<std::string> fileName(std::string_view serial);

  private:
    [[nodiscard]] std::optional<std::string> replace(const std::filesystem::path& file,
                                                     std::string_view text) const;
    void removeLeftovers(const std::string& name) const;

    std::filesystem::path folder_;
};

/// What to show with.
struct ChosenCalibration {
    enum class Origin { None, Fresh, Cached };
    Origin origin = Origin::None;
    std::string text;                  ///< empty: none was good
    std::vector<std::string> warnings; ///< one sentence each
};

/// What is wrong with a calibration's text, or nothing.
using CalibrationValidator = std::function<std::optional<std::string>(std::string_view)>;

/// `fresh` (what the display gave just now, if it did) when it is good, and then keeps it; else the
/// last good one, with a warning. A cached one is validated too.
[[nodiscard]] ChosenCalibration chooseCalibration(std::string_view serial,
                                                  const std::optional<std::string>& fresh,
                                                  const CalibrationValidator& problemWith,
                                                  const CalibrationCache& cache);

} // namespace autostereo::devices
