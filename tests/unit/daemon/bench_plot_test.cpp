#include "tests/bench/views/row.hpp"

#include <gtest/gtest.h>

#include <string>

namespace autostereo::bench {
namespace {

TEST(BenchPlot, IsWellFormed) {
    Row row;
    row.scene = "sim:room?depth=640x480&noise=off";
    row.display = "looking-glass-portrait";
    row.cpuMs = 100;
    row.psnrDb = 40;
    std::vector<Row> rows{row, row, row};
    rows[0].method = "multipass";
    rows[1].method = "direct";
    rows[2].method = "auto, 40 dB: direct"; // the same point again
    const std::string svg = plot(rows);
    EXPECT_NE(svg.find("depth=640x480&amp;noise=off"), std::string::npos);
    for (std::size_t at = svg.find('&'); at != std::string::npos; at = svg.find('&', at + 1))
        EXPECT_EQ(svg.substr(at, 5), "&amp;");
    EXPECT_NE(svg.find(">direct<"), std::string::npos);
    EXPECT_EQ(svg.find(">auto"), std::string::npos);
}

} // namespace
} // namespace autostereo::bench
