#include "tests/support/rendered_head.hpp"

#include "tests/support/data.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <random>

namespace autostereo::test {

namespace {

/// The portrait's pupils (README.md there); the viewer's left eye is on the right.
constexpr glm::dvec2 kLeftPupil{101.3, 96.7}, kRightPupil{58.4, 94.3}, kNose{80, 119.5};
constexpr double kMetresPerTexel = 0.063 / 43;
constexpr int kStep = 2;    ///< texels between vertices
constexpr int kSamples = 3; ///< a pixel's, each way
constexpr std::uint16_t kBackdropMm = 2500;

/// Hair, ears, chin and neck.
constexpr std::array<glm::dvec2, 32> kOutline{
    {{84, 10},   {65, 14},   {48, 25},   {38, 31},   {20, 44},   {11, 58},   {8, 67},
     {10, 84},   {13, 98},   {21, 106},  {26, 114},  {30, 121},  {36, 126},  {38, 144},
     {41, 164},  {43, 176},  {62, 180},  {90, 183},  {109, 179}, {111, 167}, {119, 151},
     {124, 130}, {131, 128}, {135, 121}, {145, 114}, {151, 101}, {156, 84},  {155, 66},
     {151, 51},  {143, 36},  {128, 24},  {108, 14}}};

bool isInside(const glm::dvec2& at) {
    bool inside = false;
    for (std::size_t i = 0, j = kOutline.size() - 1; i < kOutline.size(); j = i++) {
        const glm::dvec2 &a = kOutline[i], &b = kOutline[j];
        if ((a.y > at.y) != (b.y > at.y) && at.x < (b.x - a.x) * (at.y - a.y) / (b.y - a.y) + a.x)
            inside = !inside;
    }
    return inside;
}

double bump(const glm::dvec2& from, double sigmaX, double sigmaY) {
    return std::exp(-0.5 *
                    (from.x * from.x / (sigmaX * sigmaX) + from.y * from.y / (sigmaY * sigmaY)));
}

/// How far the face is before the ears' plane, metres, at `texel`.
double reliefAt(const glm::dvec2& texel) {
    const glm::dvec2 middle = (kLeftPupil + kRightPupil) / 2.0;
    const glm::dvec2 at = (texel - middle) * kMetresPerTexel;
    const double ball = 1 - at.x * at.x / (0.115 * 0.115) - at.y * at.y / (0.145 * 0.145);
    return 0.10 * std::sqrt(std::max(0.0, ball)) +
           0.022 * bump((texel - kNose) * kMetresPerTexel, 0.009, 0.016) -
           0.005 * (bump((texel - kLeftPupil) * kMetresPerTexel, 0.013, 0.010) +
                    bump((texel - kRightPupil) * kMetresPerTexel, 0.013, 0.010));
}

/// Columns: where the head's own right, down and back point to when it faces the camera from
/// `middle`, then is turned.
glm::dmat3 orientation(const HeadView& view) {
    const glm::dvec3 back = glm::normalize(view.middle);
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3{0, 1, 0}, back));
    const glm::dmat3 facing{right, glm::cross(back, right), back};
    const double cy = std::cos(view.yaw), sy = std::sin(view.yaw);
    const double cp = std::cos(view.pitch), sp = std::sin(view.pitch);
    const double cr = std::cos(view.roll), sr = std::sin(view.roll);
    const glm::dmat3 yaw{{cy, 0, -sy}, {0, 1, 0}, {sy, 0, cy}};
    const glm::dmat3 pitch{{1, 0, 0}, {0, cp, sp}, {0, -sp, cp}};
    const glm::dmat3 roll{{cr, sr, 0}, {-sr, cr, 0}, {0, 0, 1}};
    return facing * yaw * pitch * roll;
}

/// One corner as the camera sees it.
struct Corner {
    glm::dvec3 place;
    glm::dvec2 sample; ///< of the picture with kSamples a pixel
    glm::dvec2 texel;
};

/// Samples, of which kSamples squared make a pixel, of the part of a picture that the head covers.
struct Canvas {
    int left, top, width, height; ///< samples of the whole picture
    std::vector<double> depth;
    std::vector<glm::vec3> color; ///< red below 0: nothing there

    Canvas(const std::vector<Corner>& corners, const RgbPicture& picture) {
        glm::dvec2 least{1e9}, most{-1e9};
        for (const Corner& corner : corners) {
            least = glm::min(least, corner.sample);
            most = glm::max(most, corner.sample);
        }
        const auto inside = [](double at, int size) {
            return static_cast<int>(std::clamp(at, 0.0, 1.0 * kSamples * size));
        };
        left = inside(least.x, picture.width);
        top = inside(least.y, picture.height);
        width = inside(most.x + 1, picture.width) - left;
        height = inside(most.y + 1, picture.height) - top;
        const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        depth.assign(count, std::numeric_limits<double>::infinity());
        color.assign(count, glm::vec3{-1});
    }
    /// Of a sample of the whole picture; none outside of the canvas.
    [[nodiscard]] std::optional<std::size_t> indexOf(int column, int row) const {
        const int x = column - left, y = row - top;
        if (x < 0 || y < 0 || x >= width || y >= height) return std::nullopt;
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

template<class Color>
void drawTriangle(Canvas& canvas, const std::array<Corner, 3>& c, const Color& color) {
    const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) {
        return a.x * b.y - a.y * b.x;
    };
    const double area = cross(c[1].sample - c[0].sample, c[2].sample - c[0].sample);
    if (std::abs(area) < 1e-9) return;
    const auto least = [&](auto axis) { return std::min({axis(c[0]), axis(c[1]), axis(c[2])}); };
    const auto most = [&](auto axis) { return std::max({axis(c[0]), axis(c[1]), axis(c[2])}); };
    const auto x = [](const Corner& k) { return k.sample.x; };
    const auto y = [](const Corner& k) { return k.sample.y; };
    const int left = static_cast<int>(std::ceil(least(x)));
    const int right = static_cast<int>(std::floor(most(x)));
    const int top = static_cast<int>(std::ceil(least(y)));
    const int bottom = static_cast<int>(std::floor(most(y)));
    for (int row = top; row <= bottom; ++row)
        for (int column = left; column <= right; ++column) {
            const glm::dvec2 at{column, row};
            const double b0 = cross(c[1].sample - at, c[2].sample - at) / area;
            const double b1 = cross(c[2].sample - at, c[0].sample - at) / area;
            const double b2 = 1 - b0 - b1;
            const auto i = canvas.indexOf(column, row);
            if (!i || b0 < 0 || b1 < 0 || b2 < 0) continue;
            const double w0 = b0 / c[0].place.z, w1 = b1 / c[1].place.z, w2 = b2 / c[2].place.z;
            const double z = 1 / (w0 + w1 + w2);
            if (z >= canvas.depth[*i]) continue;
            canvas.depth[*i] = z;
            canvas.color[*i] = color((w0 * c[0].texel + w1 * c[1].texel + w2 * c[2].texel) * z);
        }
}

std::array<float, 7> sevenTaps(double sigma) {
    std::array<float, 7> weights{};
    double sum = 0;
    for (int i = -3; i <= 3; ++i)
        sum += std::exp(-0.5 * i * i / (sigma * sigma));
    int i = -3;
    for (float& weight : weights) {
        weight = static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma)) / sum);
        ++i;
    }
    return weights;
}

/// Along rows into columns; twice it is both ways round.
std::vector<glm::vec3> blurred(const std::vector<glm::vec3>& picture, int width, int height,
                               const std::array<float, 7>& weights) {
    std::vector<glm::vec3> result(picture.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            glm::vec3 sum{0};
            int column = x - 3;
            for (const float weight : weights)
                sum +=
                    weight * picture[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                     static_cast<std::size_t>(std::clamp(column++, 0, width - 1))];
            result[static_cast<std::size_t>(x) * static_cast<std::size_t>(height) +
                   static_cast<std::size_t>(y)] = sum;
        }
    return result;
}

/// The mean of a pixel's samples, the backdrop where there is nothing else.
glm::vec3 pixelOf(const Canvas& canvas, const glm::vec3& behind, int x, int y) {
    glm::vec3 sum{0};
    for (int row = 0; row < kSamples; ++row)
        for (int column = 0; column < kSamples; ++column) {
            const auto i = canvas.indexOf(x * kSamples + column, y * kSamples + row);
            sum += i && canvas.color[*i].x >= 0 ? canvas.color[*i] : behind;
        }
    return sum / static_cast<float>(kSamples * kSamples);
}

/// The canvas over the backdrop, blurred, lit, noisy.
RgbPicture developed(const Canvas& canvas, const RgbPicture& backdrop, const HeadView& view) {
    const int width = backdrop.width, height = backdrop.height;
    std::vector<glm::vec3> picture;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::uint8_t* behind = &backdrop.rgb[3 * picture.size()];
            picture.push_back(static_cast<float>(view.gain) *
                              pixelOf(canvas, {behind[0], behind[1], behind[2]}, x, y));
        }
    const auto weights = sevenTaps(std::max(0.05, view.blurPx));
    picture = blurred(blurred(picture, width, height, weights), height, width, weights);
    std::mt19937 random(view.seed);
    std::normal_distribution<float> noise(0, static_cast<float>(std::max(1e-6, view.noise)));
    RgbPicture result{width, height, std::vector<std::uint8_t>(3 * picture.size())};
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const float grain = noise(random);
        for (int c = 0; c < 3; ++c)
            result.rgb[3 * i + static_cast<std::size_t>(c)] = static_cast<std::uint8_t>(
                std::clamp(std::round(picture[i][c] + grain), 0.0F, 255.0F));
    }
    return result;
}

std::vector<std::uint16_t> measured(const Canvas& canvas, const RgbPicture& backdrop) {
    std::vector<std::uint16_t> depth;
    for (int y = 0; y < backdrop.height; ++y)
        for (int x = 0; x < backdrop.width; ++x) {
            const auto i = canvas.indexOf(x * kSamples + kSamples / 2, y * kSamples + kSamples / 2);
            const bool head = i && std::isfinite(canvas.depth[*i]);
            depth.push_back(head ? static_cast<std::uint16_t>(std::lround(1000 * canvas.depth[*i]))
                                 : kBackdropMm);
        }
    return depth;
}

} // namespace

RenderedHead::RenderedHead()
    : portrait_(readPicture(sourceDir() / "tests/data/head/astronaut.png")) {
    const int columns = portrait_.width / kStep, rows = portrait_.height / kStep;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const glm::dvec2 texel{column * kStep, row * kStep};
            vertices_.push_back({surface(texel), texel});
        }
    for (int row = 0; row + 1 < rows; ++row)
        for (int column = 0; column + 1 < columns; ++column) {
            const glm::dvec2 texel{column * kStep, row * kStep};
            if (!isInside(texel + glm::dvec2{kStep / 2.0})) continue;
            const auto i = static_cast<std::uint32_t>(row * columns + column);
            const auto below = i + static_cast<std::uint32_t>(columns);
            triangles_.insert(triangles_.end(), {i, i + 1, below, i + 1, below + 1, below});
        }
}

glm::dvec3 RenderedHead::surface(const glm::dvec2& texel) const {
    const glm::dvec2 at = (texel - (kLeftPupil + kRightPupil) / 2.0) * kMetresPerTexel;
    const double eyes = (reliefAt(kLeftPupil) + reliefAt(kRightPupil)) / 2;
    return {at, eyes - reliefAt(texel)};
}

glm::dvec3 RenderedHead::colorAt(const glm::dvec2& texel) const {
    return texelOf(portrait_, texel);
}

double RenderedHead::eyeSpacingM() const {
    return glm::length(surface(kLeftPupil) - surface(kRightPupil));
}

HeadPicture RenderedHead::draw(const calib::CameraModel& camera, const RgbPicture& backdrop,
                               const HeadView& view) const {
    const glm::dmat3 turn = orientation(view);
    std::vector<Corner> corners;
    for (const Vertex& vertex : vertices_) {
        const glm::dvec3 place = view.middle + turn * vertex.place;
        const glm::dvec2 pixel = camera.project(place).value_or(glm::dvec2{-1e3});
        // The middle sample of a pixel is at its centre.
        corners.push_back({place, pixel * double{kSamples} + (kSamples - 1) / 2.0, vertex.texel});
    }
    Canvas canvas(corners, backdrop);
    for (std::size_t i = 0; i + 2 < triangles_.size(); i += 3) {
        const std::array<Corner, 3> three{corners[triangles_[i]], corners[triangles_[i + 1]],
                                          corners[triangles_[i + 2]]};
        const glm::dvec3 normal = glm::normalize(
            glm::cross(three[1].place - three[0].place, three[2].place - three[0].place));
        const double light = 1 + view.fromTheSide * normal.x;
        drawTriangle(canvas, three,
                     [&](const glm::dvec2& texel) { return glm::vec3(light * colorAt(texel)); });
    }
    return {developed(canvas, backdrop, view),
            measured(canvas, backdrop),
            {view.middle + turn * surface(kLeftPupil), view.middle + turn * surface(kRightPupil)}};
}

} // namespace autostereo::test
