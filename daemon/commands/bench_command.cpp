#include "daemon/commands/commands.hpp"
#include "devices/replay/whole_file.hpp"
#include "tests/bench/views/row.hpp"

#include <iostream>

namespace autostereo::daemon {

namespace {

bool isSameScene(const bench::Row& a, const bench::Row& b) {
    return a.scene == b.scene && a.display == b.display && a.grid == b.grid && a.views == b.views;
}

/// One picture a scene: 1.svg, 2.svg, ... in the order of the table.
void writePlots(const std::filesystem::path& folder, const std::vector<bench::Row>& rows) {
    std::filesystem::create_directories(folder);
    int number = 0;
    for (auto first = rows.begin(); first != rows.end();) {
        auto last = first;
        while (last != rows.end() && isSameScene(*first, *last))
            ++last;
        devices::writeWhole(folder / (std::to_string(++number) + ".svg"),
                            bench::plot({first, last}), "bench: ");
        first = last;
    }
}

} // namespace

int benchmark(const BenchOptions& options) {
    const auto rows = bench::run(
        options.request, [](const std::string& what) { std::cerr << "bench: " << what << '\n'; });
    std::cout << bench::markdown(rows);
    if (options.json) devices::writeWhole(*options.json, bench::json(rows), "bench: ");
    if (options.plot) writePlots(*options.plot, rows);
    return EXIT_SUCCESS;
}

} // namespace autostereo::daemon
