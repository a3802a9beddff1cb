#include "calib/message_picture.hpp"

#include "calib/glyphs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace autostereo::calib {

namespace {

constexpr int kAdvance = Glyph::kWidth + 1; // cells from letter to letter
constexpr int kLineHeight = Glyph::kHeight; // cells from line to line
constexpr std::array<std::uint8_t, 3> kInk{240, 240, 240};

using Lines = std::vector<std::u32string>;

/// Words in lines of at most so many letters; longer words are broken.
Lines wrapped(const std::u32string& text, std::size_t most) {
    Lines lines{{}};
    std::u32string word;
    const auto place = [&] {
        for (; word.size() > most; word.erase(0, most)) {
            if (!lines.back().empty()) lines.emplace_back();
            lines.back() = word.substr(0, most);
        }
        if (word.empty()) return;
        const std::size_t gap = lines.back().empty() ? 0 : 1;
        if (lines.back().size() + gap + word.size() > most)
            lines.emplace_back();
        else
            lines.back().append(gap, U' ');
        lines.back() += word;
        word.clear();
    };
    for (const char32_t letter : text) {
        if (letter == U' ' || letter == U'\n')
            place();
        else
            word += letter;
    }
    place();
    return lines;
}

struct Layout {
    int cell = 1; ///< pixels
    Lines lines;
};

/// The largest letters that fit without breaking a word; else the smallest.
Layout layout(const std::u32string& text, int width, int height) {
    const int widest = 4 * width / 5, highest = height / 2;
    std::size_t longest = 0, letters = 0;
    for (const char32_t letter : text)
        longest = std::max(longest, letters = letter == U' ' ? 0 : letters + 1);
    for (int cell = std::max(1, std::min(width, height) / 60);; --cell) {
        const auto most = static_cast<std::size_t>(std::max(1, (widest / cell + 1) / kAdvance));
        Lines lines = wrapped(text, most);
        const int high = static_cast<int>(lines.size()) * kLineHeight * cell;
        if (cell == 1 || (longest <= most && high <= highest)) return {cell, std::move(lines)};
    }
}

Picture plain(int width, int height) {
    Picture picture{width, height, {}};
    picture.pixels.reserve(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = 0; y < height; ++y) {
        const auto level = static_cast<std::uint8_t>(40 - 24 * y / height); // darker below
        const std::array<std::uint8_t, 4> color{level, static_cast<std::uint8_t>(level + 4),
                                                static_cast<std::uint8_t>(level + 12), 255};
        for (int x = 0; x < width; ++x)
            picture.pixels.insert(picture.pixels.end(), color.begin(), color.end());
    }
    return picture;
}

/// Mean of the pixels under one of the target's, so that nothing is left out; nearest when larger.
void fit(const Picture& from, Picture& to) {
    const double scale = std::min(static_cast<double>(to.width) / from.width,
                                  static_cast<double>(to.height) / from.height);
    const auto fitted = [&](int size, int most) {
        return std::clamp(static_cast<int>(std::lround(size * scale)), 1, most);
    };
    const int width = fitted(from.width, to.width), height = fitted(from.height, to.height);
    const int left = (to.width - width) / 2, top = (to.height - height) / 2;
    const auto span = [](int at, int count, int source) {
        const auto first = static_cast<int>(static_cast<std::int64_t>(at) * source / count);
        const auto end = static_cast<int>(static_cast<std::int64_t>(at + 1) * source / count);
        return std::array{first, std::max(end, first + 1)};
    };
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto [x0, x1] = span(x, width, from.width);
            const auto [y0, y1] = span(y, height, from.height);
            std::array<std::uint32_t, 3> sum{};
            for (int v = y0; v < y1; ++v)
                for (int u = x0; u < x1; ++u)
                    for (std::size_t c = 0; c < 3; ++c)
                        sum[c] += from.pixels[from.offset(u, v) + c];
            const auto count =
                static_cast<std::uint32_t>(x1 - x0) * static_cast<std::uint32_t>(y1 - y0);
            for (std::size_t c = 0; c < 3; ++c)
                to.pixels[to.offset(left + x, top + y) + c] =
                    static_cast<std::uint8_t>((sum[c] + count / 2) / count);
        }
}

void fill(Picture& picture, int x, int y, int width, int height, std::uint8_t keep) {
    for (int v = std::max(0, y); v < std::min(picture.height, y + height); ++v)
        for (int u = std::max(0, x); u < std::min(picture.width, x + width); ++u)
            for (std::size_t c = 0; c < 3; ++c) {
                std::uint8_t& level = picture.pixels[picture.offset(u, v) + c];
                level = keep == 0 ? kInk.at(c) : static_cast<std::uint8_t>(level * keep / 255);
            }
}

void write(Picture& picture, const std::u32string& line, int left, int top, int cell) {
    for (const char32_t letter : line) {
        const Glyph glyph = glyphOf(letter);
        for (int row = 0; row < Glyph::kHeight; ++row)
            for (int column = 0; column < Glyph::kWidth; ++column)
                if (glyph.has(column, row))
                    fill(picture, left + column * cell, top + row * cell, cell, cell, 0);
        left += kAdvance * cell;
    }
}

} // namespace

Picture messagePicture(const Picture& background, std::string_view text, int width, int height) {
    Picture picture = plain(width, height);
    if (!background.empty()) fit(background, picture);
    if (text.empty()) return picture;
    const auto [cell, lines] = layout(lettersOf(text), width, height);
    const auto widthOf = [cell = cell](const std::u32string& line) {
        return (static_cast<int>(line.size()) * kAdvance - 1) * cell;
    };
    const int high = static_cast<int>(lines.size()) * kLineHeight * cell;
    int top = (height - high) / 2;
    constexpr std::uint8_t kShade = 64; // a quarter, behind the words
    if (!background.empty()) fill(picture, 0, top - 2 * cell, width, high + 4 * cell, kShade);
    for (const std::u32string& line : lines) {
        write(picture, line, (width - widthOf(line)) / 2, top, cell);
        top += kLineHeight * cell;
    }
    return picture;
}

} // namespace autostereo::calib
