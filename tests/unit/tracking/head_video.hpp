#pragma once

#include "devices/frame_pool.hpp"
#include "tests/support/rendered_head.hpp"

#include <algorithm>
#include <random>
#include <span>
#include <vector>

namespace autostereo::test {

/// A camera of 640x480 pixels and 60 degrees from left to right.
inline calib::CameraModel webcam() {
    calib::CameraModel camera;
    camera.intrinsics = {640, 480, 554, 554, 319.5, 239.5};
    return camera;
}

/// A viewer who walks about before it at 0.6 to 1.5 m, 15 pictures a walk: turned from the camera
/// by up to 12 degrees, nodding and leaning by up to 10, in light that changes from 45 to 125 % and
/// from cheek to cheek, blurred and noisy.
inline std::vector<HeadView> walks(int count, std::uint32_t seed) {
    constexpr int kPictures = 15;
    std::mt19937 random(seed);
    const auto between = [&](double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random);
    };
    const auto somewhere = [&] {
        HeadView view;
        const double z = between(0.6, 1.5);
        view.middle = {between(-0.42, 0.42) * z, between(-0.28, 0.28) * z, z};
        view.yaw = between(-0.21, 0.21);
        view.pitch = between(-0.175, 0.175);
        view.roll = between(-0.175, 0.175);
        view.gain = between(0.45, 1.25);
        view.fromTheSide = between(-0.5, 0.5);
        return view;
    };
    std::vector<HeadView> views;
    for (int walk = 0; walk < count; ++walk) {
        const HeadView from = somewhere(), to = somewhere();
        const double blur = between(0.4, 1.1), noise = between(1, 5);
        for (int i = 0; i < kPictures; ++i) {
            const double share = i / (kPictures - 1.0);
            const auto mix = [share](auto a, auto b) { return a + (b - a) * share; };
            HeadView view = from;
            view.middle = mix(from.middle, to.middle);
            view.yaw = mix(from.yaw, to.yaw);
            view.pitch = mix(from.pitch, to.pitch);
            view.roll = mix(from.roll, to.roll);
            view.gain = mix(from.gain, to.gain);
            view.fromTheSide = mix(from.fromTheSide, to.fromTheSide);
            view.blurPx = blur;
            view.noise = noise;
            view.seed = static_cast<std::uint32_t>(random());
            views.push_back(view);
        }
    }
    return views;
}

/// Leased from `pool`.
inline devices::Frame colorFrame(devices::FramePool& pool, const RgbPicture& picture,
                                 devices::TimePoint at) {
    devices::FrameMetadata form;
    form.format = devices::PixelFormat::Rgb8;
    form.width = picture.width;
    form.height = picture.height;
    form.capturedAt = at;
    devices::Frame frame = std::move(*pool.acquire(form));
    std::ranges::copy(std::as_bytes(std::span(picture.rgb)), frame.pixels().begin());
    return frame;
}

} // namespace autostereo::test
