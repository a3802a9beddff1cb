#include "devices/grey_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include <glm/geometric.hpp>

namespace autostereo::devices {

namespace {

/// Distance at which the light has faded to a half.
constexpr float kHalfLightM = 3.0F;
/// Light that reaches surfaces seen edge-on, so that they stand out from holes.
constexpr float kAmbient = 0.2F;
/// Neighbours whose depths differ by more than this fraction belong to different surfaces.
constexpr float kSameSurface = 0.05F;

bool measured(std::uint16_t counts) { return counts != 0 && counts != 65535; }

/// Points of one frame, on demand.
struct Surface {
    std::span<const std::uint16_t> depth;
    std::span<const glm::vec3> rays;
    float unitM;
    int width;
    int height;

    [[nodiscard]] std::optional<glm::vec3> at(int x, int y) const {
        if (x < 0 || y < 0 || x >= width || y >= height) return std::nullopt;
        const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(x);
        if (!measured(depth[i]) || rays[i].z == 0.0F) return std::nullopt;
        return rays[i] * (static_cast<float>(depth[i]) * unitM);
    }

    /// Along the surface from the neighbour before to the one after, or from the point itself.
    [[nodiscard]] glm::vec3 tangent(const glm::vec3& point, int x, int y, int dx, int dy) const {
        const auto near = [&](int side) {
            const auto neighbour = at(x + side * dx, y + side * dy);
            const bool same =
                neighbour && std::abs(neighbour->z - point.z) <= kSameSurface * point.z;
            return same ? *neighbour : point;
        };
        return near(1) - near(-1);
    }

    [[nodiscard]] std::uint8_t shade(int x, int y) const {
        const auto point = at(x, y);
        if (!point) return 0;
        const glm::vec3 normal =
            glm::cross(tangent(*point, x, y, 1, 0), tangent(*point, x, y, 0, 1));
        const float size = glm::length(normal) * glm::length(*point);
        // A point without neighbours on its surface is taken as facing the camera.
        const float facing = size > 0.0F ? std::abs(glm::dot(normal, *point)) / size : 1.0F;
        const float fade = kHalfLightM / (kHalfLightM + point->z);
        const float light = (kAmbient + (1.0F - kAmbient) * facing) * fade;
        return static_cast<std::uint8_t>(std::clamp(std::lround(255.0F * light), 1L, 255L));
    }
};

} // namespace

void GreyPicture::lookUpRays(int width, int height) {
    if (width == width_ && height == height_) return;
    width_ = width;
    height_ = height;
    rays_.clear();
    const calib::CameraModel camera = camera_.resized(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto ray = camera.unproject({x, y});
            rays_.push_back(ray ? glm::vec3(ray->x, ray->y, 1.0) : glm::vec3(0.0F));
        }
}

void GreyPicture::paint(const Frame& depth, Frame& color) {
    const FrameMetadata& metadata = depth.metadata();
    lookUpRays(metadata.width, metadata.height);
    const Surface surface{depth.depth(), rays_, static_cast<float>(metadata.depthUnitM), width_,
                          height_};
    std::byte* pixel = color.pixels().data();
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x, pixel += 4) {
            std::fill_n(pixel, 3, std::byte{surface.shade(x, y)});
            pixel[3] = std::byte{255};
        }
}

} // namespace autostereo::devices
