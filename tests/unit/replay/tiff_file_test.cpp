#include "devices/replay/tiff_file.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/tiff_reader.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace autostereo {
namespace {

TEST(TiffFile, ComesBackAsItWas) {
    const test::ScratchFolder folder;
    const std::array<float, 6> samples{0.5F,  -0.0625F, 1e-30F,
                                       -0.0F, 3e30F,    std::numeric_limits<float>::min()};
    const std::string file = folder.path() / "d.tif";
    devices::writeTiff(file, 3, 2, samples);
    const test::FloatTiff tiff = test::readFloatTiff(file);
    EXPECT_EQ(tiff.width, 3);
    EXPECT_EQ(tiff.height, 2);
    EXPECT_EQ(tiff.samples, std::vector<float>(samples.begin(), samples.end()));
    EXPECT_EQ(tiff.tags.at(274), 1U) << "top row first";
    EXPECT_EQ(tiff.tags.at(277), 1U) << "one sample a pixel";
    EXPECT_EQ(tiff.tags.at(278), 2U) << "all rows in one strip";
}

TEST(TiffFile, RefusesWhatDoesNotFit) {
    const test::ScratchFolder folder;
    const std::array<float, 6> samples{};
    EXPECT_THROW(devices::writeTiff(folder.path() / "d.tif", 2, 2, samples), std::runtime_error);
    EXPECT_THROW(devices::writeTiff(folder.path() / "no/folder/d.tif", 3, 2, samples),
                 std::runtime_error);
}

} // namespace
} // namespace autostereo
