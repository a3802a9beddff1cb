#include "config/load.hpp"
#include "config/looking_glass_json.hpp"
#include "config/vendor_calibration.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own entry

namespace {

/// What can be imported has to load, and to the same numbers.
void importAs(config::Vendor vendor, std::string_view json) try {
    const auto imported = config::importDisplay(vendor, "x.json", json);
    const auto display = config::displayFromText("x.toml", imported.toml);
    if (vendor == config::Vendor::Cubevi) return;
    const auto unit = config::readLookingGlassJson("x.json", json).lens;
    const auto& lens = std::get<calib::LookingGlassCalibration>(display.law);
    fuzz::require(lens.pitch == unit.pitch && lens.slope == unit.slope &&
                      lens.center == unit.center && lens.dpi == unit.dpi &&
                      lens.cells == unit.cells && lens.pattern == unit.pattern,
                  "the written file has other numbers");
} catch (const config::ConfigError& error) {
    fuzz::requirePlain(error.what());
    // Messages about the written file would be about nothing that the user has.
    fuzz::require(std::string_view(error.what()).starts_with("x.json"), error.what());
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view json = fuzz::textOf(data, size);
    static_cast<void>(config::vendorOf(json));
    static_cast<void>(config::calibrationProblem(json));
    importAs(config::Vendor::LookingGlass, json);
    importAs(config::Vendor::Cubevi, json);
    return 0;
}
