#include "calib/panel_map.hpp"
#include "config/load.hpp"
#include "tests/fuzz/fuzz.hpp"

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own entry

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) try {
    const auto display = config::displayFromText("x.toml", fuzz::textOf(data, size));
    // What loads has to make a panel, too; a table from a file has that file's size.
    if (!std::holds_alternative<calib::ViewLut>(display.law))
        static_cast<void>(calib::panelMap(display, 64, 48));
    return 0;
} catch (const config::ConfigError& error) {
    fuzz::requirePlain(error.what());
    return 0;
}
