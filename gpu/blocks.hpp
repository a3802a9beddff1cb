#pragma once

#include "calib/disparity_law.hpp"
#include "calib/phase_tables.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cstddef>

namespace autostereo::gpu {

// Uniform blocks that several passes share, laid out as std140 in the shader of the same name;
// a test compares every offset with what the driver says.

/// shaders/mesh_block.glsl, binding 0.
struct MeshBlock {
    glm::mat4 colorFromDepth{1};
    glm::vec4 colorPinhole{0};
    glm::vec4 colorSize{0};
    glm::vec4 colorRadial{0};
    glm::vec4 colorRational{0};
    glm::vec4 framing{0};
    glm::vec4 upright{1, 0, 0, 1};
    glm::vec4 grid{0};
    glm::vec4 law{0};
    glm::vec4 budget{0};
    glm::uvec4 counts{0};
};
static_assert(sizeof(MeshBlock) == 224);

/// shaders/condition_block.glsl, binding 5.
struct ConditionBlock {
    glm::uvec4 valid{0};
    glm::uvec4 surface{0};
    glm::uvec4 hold{0};
};
static_assert(sizeof(ConditionBlock) == 48);

/// shaders/color_converter.comp, binding 6.
struct ColorBlock {
    glm::vec4 levels{0};
    glm::vec4 weights{0};
};
static_assert(sizeof(ColorBlock) == 32);

/// shaders/views_block.glsl, binding 1.
struct ViewsBlock {
    glm::ivec4 tiles{0};
    glm::vec4 range{0};
};
static_assert(sizeof(ViewsBlock) == 32);

/// shaders/interleaver_block.glsl, binding 2.
struct InterleaverBlock {
    glm::uvec4 fan{0};
    glm::ivec4 tiles{0};
    glm::ivec4 panel{0};
    glm::vec4 edge{0};
    glm::vec4 scale{0};
    glm::vec4 fine{0};
    glm::vec4 rig{0};
    glm::uvec4 atlasRow{0};
};
static_assert(sizeof(InterleaverBlock) == 128);

/// shaders/affine_phase.glsl, binding 4, for so many eyes (left to right).
template<std::size_t Eyes>
struct PhaseBlock {
    static constexpr std::size_t kCells = calib::AffinePhase::kCells;

    std::array<glm::uvec4, Eyes> phaseSteps{};
    std::array<glm::uvec4, Eyes * kCells> channels{};

    void set(std::size_t eye, const calib::AffinePhase& phase) {
        const auto upper = [](std::uint64_t number) {
            return static_cast<std::uint32_t>(number >> 16);
        };
        const auto lower = [](std::uint64_t number) {
            return static_cast<std::uint32_t>(number & 0xffff);
        };
        phaseSteps.at(eye) = {upper(phase.perColumn), upper(phase.perRow), lower(phase.perColumn),
                              lower(phase.perRow)};
        for (std::size_t cell = 0; cell < kCells; ++cell) {
            const auto& [red, green, blue] = phase.channels[cell];
            channels.at(eye * kCells + cell) = {red, green, blue, 0U};
        }
    }
};
static_assert(sizeof(PhaseBlock<1>) == 144);

/// shaders/mesh_eye.vert and mesh_camera.vert (its first member), binding 3.
struct EyeBlock {
    glm::vec4 eye{0};
    glm::vec4 form{0};
};
static_assert(sizeof(EyeBlock) == 32);
/// For mesh_eye.vert: an eye in display space, metres, and the picture's height over its width.
[[nodiscard]] inline EyeBlock eyeBlock(const calib::DisplayProfile& display, const glm::dvec3& eye,
                                       double aspect) {
    return {glm::dvec4(eye, display.viewingDistanceM) / display.widthM,
            glm::dvec4(calib::fanHalfWidth(display), aspect, 0, 0)};
}

/// shaders/edge_band.comp, fill_holes.comp and background_seeds.comp, binding 3.
struct FillBlock {
    glm::ivec4 reach{0};
};

/// shaders/list_blocks.comp, binding 7.
struct ListBlock {
    std::array<glm::ivec4, 7> reach{};
    glm::ivec4 size{0};
};
static_assert(sizeof(ListBlock) == 128);

} // namespace autostereo::gpu
