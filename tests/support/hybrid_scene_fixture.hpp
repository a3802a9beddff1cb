#pragma once

#include "calib/disparity_law.hpp"
#include "calib/view_map.hpp"
#include "tests/support/gl_references.hpp"
#include "tests/support/scene_fixture.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace autostereo::test {

/// Narrow poles before a wide card, of which two viewpoints do not see all.
inline devices::mesh::MeshScene polesBeforeCard() {
    devices::mesh::MeshScene scene = twoBalls();
    scene.nodes.clear();
    scene.indices.clear();
    scene.vertices.clear();
    const auto addCard = [&](double x, double width, double height, double z, int material) {
        const std::size_t first = scene.indices.size();
        const auto base = static_cast<std::uint32_t>(scene.vertices.size());
        for (const auto& [across, up] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
            scene.vertices.push_back({glm::vec3(x + across * width, up * height, z),
                                      glm::vec3(0, 0, 1),
                                      glm::vec2(0.5 + 0.4 * across, 0.5 - 0.4 * up)});
        for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U})
            scene.indices.push_back(base + corner);
        addNode(scene, first, material, {0, 0, 0});
    };
    addCard(0, 1, 1, -1, 0);
    for (const double x : {-0.6, -0.2, 0.3, 0.7})
        addCard(x, 0.04, 0.9, 1, 1);
    return scene;
}

inline double levelsOff(const glm::dvec3& a, const glm::dvec3& b) {
    const glm::dvec3 off = glm::abs(a - b);
    return std::max({off.r, off.g, off.b});
}

/// Eight views, none of them halfway between two references.
class HybridSceneGlTest : public SceneGlTest {
  protected:
    using Kind = ReadRoot::Kind;

    void SetUp() override {
        SceneGlTest::SetUp();
        display.views = 8;
        display.quilt = {4, 2, 96, 128};
        display.optics.kind = calib::Optics::Kind::Lens; // over stripes: thirds of a pixel
    }
    void showPoles() {
        scene = polesBeforeCard();
        params.synthesis.references = 2;
        look.share = 0.7;
    }
    [[nodiscard]] oracle::PanelForm form() const {
        return {display.widthM, display.heightM(), display.viewingDistanceM,
                calib::fanHalfWidth(display), pipeline->placement().flattening};
    }
    [[nodiscard]] double positionOf(int view) const { return calib::viewPosition(display, view); }
    /// Of a tile's pixel, y from the bottom.
    [[nodiscard]] std::size_t atlasIndex(int view, int x, int y) const {
        const gpu::AtlasLayout& layout = pipeline->atlas().layout();
        return static_cast<std::size_t>((layout.bottom(view) + y) * layout.width() +
                                        layout.left(view) + x);
    }
    [[nodiscard]] glm::dvec3 tileColor(const gpu::RgbImage& atlas, int view, int x, int y) const {
        const std::size_t across = atlasIndex(view, x, y) % static_cast<std::size_t>(atlas.width);
        const std::size_t up = atlasIndex(view, x, y) / static_cast<std::size_t>(atlas.width);
        const std::size_t row = static_cast<std::size_t>(atlas.height) - 1 - up;
        const std::size_t at = 3 * (row * static_cast<std::size_t>(atlas.width) + across);
        return {atlas.pixels[at], atlas.pixels[at + 1], atlas.pixels[at + 2]};
    }
    static Kind kindOf(const oracle::References& in, const oracle::HybridRoot& root, int y) {
        if (root.hit.isWall) return Kind::Hole;
        const bool isThere = oracle::surfaceAt(in, root.reference, y, root.hit.x).cover > 0;
        return isThere ? Kind::Seen : Kind::Nothing;
    }
    /// What a pixel is lit from, given what was found; none: a hole with nothing on either side.
    [[nodiscard]] std::optional<oracle::HybridSurface>
    surfaceSeen(const oracle::References& in, const std::vector<std::uint32_t>& roots, int view,
                int x, int y) const {
        const auto seen = [&](int at) -> std::optional<oracle::HybridSurface> {
            if (at < 0 || at >= in.tileWidth()) return std::nullopt;
            const ReadRoot root = readRoot(roots[atlasIndex(view, at, y)]);
            if (root.kind == Kind::Hole) return std::nullopt;
            if (root.kind == Kind::Nothing) return oracle::HybridSurface{};
            return oracle::surfaceAt(in, root.reference, y, root.x);
        };
        if (const auto own = seen(x)) return own;
        int left = x, right = x;
        while (left >= 0 && !seen(left))
            --left;
        while (right < in.tileWidth() && !seen(right))
            ++right;
        const auto l = seen(left), r = seen(right);
        if (!l || !r) return l ? l : r;
        return oracle::filled(*l, *r, x - left, right - x);
    }
};

} // namespace autostereo::test
