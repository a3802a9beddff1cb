// What a picture costs the host on its way to the GPU, copied and not. Stated, never judged.

#include "tests/device/zero_copy/zero_copy_fixture.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <thread>

namespace autostereo::test {
namespace {

using devices::PixelWay;

/// The guest counts a process's time in ticks of its timer, too coarse for one picture; what runs
/// here without waiting takes its processor all the time.
double nowMs() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double, std::milli>(now).count();
}

double median(std::vector<double> values) {
    std::ranges::nth_element(values,
                             values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2));
    return values[values.size() / 2];
}

double mappingMs(const devices::Frame& frame) {
    const double start = nowMs();
    const std::size_t bytes = frame.pixels().size();
    void* data = mmap(nullptr, bytes, PROT_READ, MAP_SHARED, frame.shared()->fd, 0);
    EXPECT_NE(data, MAP_FAILED);
    constexpr std::size_t kPage = 4096;
    unsigned sum = 0;
    for (std::size_t at = 0; at < bytes; at += kPage)
        sum += static_cast<const volatile unsigned char*>(data)[at];
    munmap(data, bytes);
    return sum > 0 ? nowMs() - start : 0;
}

class ZeroCopyCostTest : public ZeroCopyTest {
  protected:
    struct Costs {
        std::vector<double> capture, upload; ///< milliseconds a picture
        std::vector<double> mapping;         ///< of its memory anew, as llvmpipe does for each use
    };
    void measure(const std::string& option, PixelWay way, Costs& costs) {
        constexpr int kSettling = 2, kFrames = 5;
        uploader.emplace();
        Stream stream("v4l2:/dev/video0?format=YUYV&size=1920x1080" + option);
        for (int i = 0; i < kSettling + kFrames; ++i) {
            // vivid gives five of this size a second: by then one waits.
            std::this_thread::sleep_for(std::chrono::milliseconds(210));
            const double start = nowMs();
            devices::RgbdFrame pair;
            pair.color = stream.next();
            ASSERT_FALSE(pair.color.empty()) << stream.lost;
            const double captured = nowMs();
            upload(*uploader, pair);
            glFinish();
            const double uploaded = nowMs();
            if (i < kSettling) continue;
            costs.capture.push_back(captured - start);
            costs.upload.push_back(uploaded - captured);
            EXPECT_EQ(uploader->colorWay(), way);
            if (way == PixelWay::Filled) costs.mapping.push_back(mappingMs(pair.color));
        }
    }
};

/// Of the conversion alone, which a GPU has for itself and llvmpipe does on the host.
double conversionMs(bool marks) {
    devices::FrameMetadata form;
    form.format = devices::PixelFormat::Yuyv;
    form.width = 1920;
    form.height = 1080;
    const auto [columns, rows] = gpu::ColorConverter::byteGrid(form);
    const gpu::gl::Texture bytes(GL_R8, columns, rows), color(GL_RGBA8, form.width, form.height);
    gpu::BlockMarks marked;
    marked.resize(form.width, form.height);
    gpu::ColorConverter converter;
    std::vector<double> times;
    for (int i = 0; i < 9; ++i) {
        const double start = nowMs();
        converter.convert(form, bytes.name(), color, marks ? &marked : nullptr);
        glFinish();
        if (i > 1) times.push_back(nowMs() - start); // the program is made first
    }
    return median(times);
}

TEST_F(ZeroCopyCostTest, OfAFullHdPicture) {
    if (IsSkipped()) return;
    constexpr int kNoise = 21; // as a camera's: every block is another one in every picture
    Vivid::set("Test Pattern", kNoise);
    Costs copied, filled;
    for (int round = 0; round < 2; ++round) {
        measure("&zero_copy=off", PixelWay::Copied, copied);
        measure("", PixelWay::Filled, filled);
    }
    const double plain = conversionMs(false), marking = conversionMs(true);
    std::cout << "Time of a 1920x1080 YUYV picture in ms, " << copied.upload.size()
              << " each, in turn, medians: copied " << median(copied.capture) << " to capture, "
              << median(copied.upload) << " to upload and convert, of which converting takes "
              << plain << "; not copied " << median(filled.capture) << ", " << median(filled.upload)
              << " and " << marking << ", and llvmpipe's mapping of the memory "
              << median(filled.mapping) << '\n';
}

} // namespace
} // namespace autostereo::test
