// The converter marks the blocks whose colours it changes, and makes the same colours as without.

#include "gpu/color_converter.hpp"
#include "tests/support/gl_fixture.hpp"

#include <algorithm>
#include <random>
#include <vector>

namespace autostereo::test {
namespace {

using devices::PixelFormat;
using ColorMarksGlTest = GlTest;

std::vector<std::uint8_t> read(const gpu::gl::Texture& texture, GLenum format, std::size_t bytes) {
    std::vector<std::uint8_t> all(bytes * static_cast<std::size_t>(texture.width()) *
                                  static_cast<std::size_t>(texture.height()));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glGetTextureImage(texture.name(), 0, format, GL_UNSIGNED_BYTE, static_cast<GLsizei>(all.size()),
                      all.data());
    return all;
}

TEST_F(ColorMarksGlTest, BlocksAreMarkedWhereAPixelBecomesAnotherAndNowhereElse) {
    if (IsSkipped()) return;
    constexpr int kWidth = 54, kHeight = 38; // blocks that are cut off on both sides
    std::mt19937 random(7);
    gpu::ColorConverter converter;
    for (const PixelFormat format : {PixelFormat::Yuyv, PixelFormat::Uyvy, PixelFormat::Nv12,
                                     PixelFormat::Grey8, PixelFormat::Rgb8, PixelFormat::Bgr8}) {
        SCOPED_TRACE(static_cast<int>(format));
        devices::FrameMetadata form;
        form.format = format;
        form.width = kWidth;
        form.height = kHeight;
        const auto [columns, rows] = gpu::ColorConverter::byteGrid(form);
        const gpu::gl::Texture bytes(GL_R8, columns, rows);
        const gpu::gl::Texture marking(GL_RGBA8, kWidth, kHeight), plain(GL_RGBA8, kWidth, kHeight);
        gpu::BlockMarks marks;
        marks.resize(kWidth, kHeight);
        std::vector<std::uint8_t> raw(devices::frameBytes(format, kWidth, kHeight));
        std::ranges::generate(raw, [&] { return static_cast<std::uint8_t>(random()); });
        std::size_t changed = 0;
        for (int turn = 0; turn < 12; ++turn) {
            for (int i = 0; i < turn % 4; ++i) // none in every fourth
                raw[random() % raw.size()] ^= 0xff;
            glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
            glTextureSubImage2D(bytes.name(), 0, 0, 0, columns, rows, GL_RED, GL_UNSIGNED_BYTE,
                                raw.data());
            const auto before = read(marking, GL_RGBA, 4);
            marks.clear();
            converter.convert(form, bytes.name(), marking, &marks);
            converter.convert(form, bytes.name(), plain);
            const auto after = read(marking, GL_RGBA, 4);
            ASSERT_EQ(after, read(plain, GL_RGBA, 4));
            if (turn == 0) continue; // nothing was there
            std::vector<std::uint8_t> expected(static_cast<std::size_t>(7 * 5));
            for (std::size_t b = 0; b < after.size(); ++b)
                if (after[b] != before[b])
                    expected[b / 4 / kWidth / 8 * 7 + b / 4 % kWidth / 8] = 1;
            EXPECT_EQ(read(marks.texture(), GL_RED_INTEGER, 1), expected);
            changed += static_cast<std::size_t>(std::ranges::count(expected, 1));
        }
        EXPECT_GT(changed, 10U);
    }
}

} // namespace
} // namespace autostereo::test
