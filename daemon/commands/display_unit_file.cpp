#include "daemon/commands/display_unit_file.hpp"

#include "calib/optics.hpp"
#include "config/load.hpp"
#include "daemon/command_line.hpp"

#include <cmath>

namespace autostereo::daemon {

std::string unitFile(const std::string& assumed, const std::filesystem::path& file,
                     const MeasuredDisplay& measured) {
    std::vector<config::MeasuredValue> values;
    for (const calibrate::MeasuredNumber& number : measured.numbers)
        values.push_back({number.table, number.key, number.value, number.half95});
    config::MeasuredGrid grid;
    if (measured.by == config::MeasuredBy::Photographs)
        grid = *calib::phaseGrid(measured.display.law);
    std::string text = config::measuredDisplay(assumed, values, grid, measured.by);
    const auto written = config::displayFromText(file.string(), text);
    const calib::LensArray is = calib::displayOptics(written)->lenses;
    const calib::LensArray should = calib::displayOptics(measured.display)->lenses;
    constexpr double kRounding = 1e-9; // relative
    const auto differs = [](double a, double b, double scale) {
        return std::abs(a - b) > kRounding * scale;
    };
    if (differs(is.pitchM, should.pitchM, should.pitchM) || differs(is.slant, should.slant, 1) ||
        differs(is.axisM, should.axisM, measured.display.widthM) ||
        differs(is.gapM, should.gapM, should.gapM) ||
        is.correction.cycles.empty() != should.correction.cycles.empty())
        throw UsageError("--display: " + assumed +
                         " gives its lenses by keys that overrule the measured ones (give it by "
                         "subpixels_per_lens, row_shift_subpixels, without mirror)");
    return text;
}

} // namespace autostereo::daemon
