#pragma once

#include "calib/solve/board_detector.hpp"
#include "devices/replay/grey_image.hpp"
#include "tests/support/data.hpp"

#include <string>
#include <vector>

namespace autostereo::calibrate {

/// The boards found in files of the test data.
inline std::vector<BoardView> boardsIn(const std::vector<std::string>& files, const Board& board) {
    std::vector<BoardView> views;
    for (const std::string& file : files) {
        const devices::GreyPixels grey = devices::readGrey(test::dataDir() / file);
        if (auto view =
                findBoard({grey.width, grey.height, grey.values, grey.is16Bit}, board, file))
            views.push_back(std::move(*view));
    }
    return views;
}

constexpr Board kStereoBoard{9, 6, 1.0, {}};
constexpr Board kTofBoard{11, 8, 1.0, {}};

inline std::vector<std::string> stereoFiles(const std::string& side) {
    std::vector<std::string> files;
    for (const char* number :
         {"01", "02", "03", "04", "05", "06", "07", "08", "09", "11", "12", "13", "14"})
        files.push_back("stereo-chess/" + side + number + ".jpg");
    return files;
}

inline std::vector<std::string> tofFiles(const std::string& kind) {
    std::vector<std::string> files;
    for (const char* number : {"1", "3", "4", "5", "6", "7", "8"})
        files.push_back("tof-chess/" + std::string(number) + kind);
    return files;
}

} // namespace autostereo::calibrate
