#include "daemon/commands/board_gatherer.hpp"

#include "calib/solve/board_detector.hpp"
#include "devices/input.hpp"

#include <chrono>

namespace autostereo::daemon {

double stampOf(const devices::Frame& frame) {
    return std::chrono::duration<double>(frame.metadata().capturedAt.time_since_epoch()).count();
}

BoardGatherer::BoardGatherer(const calibrate::Board& board, FoundBoards& found, bool isDepth)
    : board_(board), found_(found), isDepth_(isDepth),
      views_(isDepth ? found.views.depth : found.views.color),
      width_(isDepth ? found.sizes.depthWidth : found.sizes.colorWidth),
      height_(isDepth ? found.sizes.depthHeight : found.sizes.colorHeight) {}

std::optional<calibrate::BoardView> BoardGatherer::find(const devices::GreyPixels& picture,
                                                        const std::string& name) {
    if (width_ == 0) {
        width_ = picture.width;
        height_ = picture.height;
    }
    if (picture.width != width_ || picture.height != height_)
        throw devices::DeviceError("calibrate: " + name + " is " + std::to_string(picture.width) +
                                   "x" + std::to_string(picture.height) + ", those before it " +
                                   std::to_string(width_) + "x" + std::to_string(height_));
    auto view = calibrate::findBoard({width_, height_, picture.values, isDepth_ || picture.is16Bit},
                                     board_, name);
    if (!view) found_.withoutBoard.push_back(name);
    return view;
}

std::size_t BoardGatherer::take(calibrate::BoardView view) {
    views_.push_back(std::move(view));
    return views_.size() - 1;
}

std::size_t BoardGatherer::take(calibrate::BoardView view, const devices::Frame& frame) {
    found_.colorTimesS.push_back(stampOf(frame));
    return take(std::move(view));
}

std::optional<std::size_t> BoardGatherer::look(const devices::GreyPixels& picture,
                                               const std::string& name) {
    auto view = find(picture, name);
    if (!view) return std::nullopt;
    return take(std::move(*view));
}

std::optional<std::size_t> BoardGatherer::lookAtDepth(const devices::Frame& frame,
                                                      const std::string& name) {
    const auto amplitude = frame.amplitude();
    if (amplitude.empty()) return std::nullopt;
    const auto& form = frame.metadata();
    const std::vector<std::uint16_t> amplitudes{amplitude.begin(), amplitude.end()};
    const auto place = look({form.width, form.height, amplitudes, true}, name + " (infrared)");
    if (!place) return std::nullopt;
    const auto depth = frame.depth();
    found_.depthTimesS.push_back(stampOf(frame));
    found_.depthPictures.push_back(
        {form.width, form.height, form.depthUnitM, {depth.begin(), depth.end()}, amplitudes});
    return place;
}

} // namespace autostereo::daemon
