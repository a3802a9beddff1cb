#include "tests/device/tof/stairs_show.hpp"

#include "tests/device/uvc/jpeg_picture.hpp"

#include <algorithm>
#include <random>

namespace autostereo::test {

namespace {

Kinect2Show makeShow() {
    Kinect2Show show;
    show.unit = inventedUnit();
    std::mt19937_64 random(20);
    for (std::size_t i = 0; i < kExposures; ++i) {
        show.exposures.push_back(expose(
            show.unit, [i](int x, int y) { return showedPoint(i, x, y); }, 0, random));
        show.jpegs.push_back(jpegPicture(1920, 1080, static_cast<unsigned>(i)));
    }
    return show;
}

} // namespace

LitPoint showedPoint(std::size_t exposure, int x, int y) {
    const int block = x / 64 + y / 53 + 3 * static_cast<int>(exposure);
    const double depth = 800 + 400 * (block % 8);
    return {depth, std::min(1500.0, 1.6e9 / (depth * depth))};
}

Kinect2Show stairsShow(double fps) {
    static const Kinect2Show kShow = makeShow();
    Kinect2Show show = kShow;
    show.fps = fps;
    return show;
}

} // namespace autostereo::test
