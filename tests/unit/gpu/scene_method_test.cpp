#include "gpu/scene/scene_pipeline.hpp"

#include <gtest/gtest.h>

namespace autostereo::gpu {
namespace {

constexpr std::size_t kFew = 968, kMany = 69'451; // suzanne, the bunny

calib::DisplayProfile displayOf(int views, calib::DisplayLaw law = calib::LinearPhase{}) {
    calib::DisplayProfile display;
    display.views = views;
    display.law = std::move(law);
    return display;
}

TEST(SceneMethod, AutoSearchesWhereThereIsMuchToDraw) {
    const auto portrait = displayOf(48), slanted = displayOf(8);
    const auto chosen = [](const calib::DisplayProfile& display, std::size_t triangles) {
        return sceneMethod(Method::Auto, SceneShading::PerPixel, display, triangles);
    };
    EXPECT_EQ(chosen(portrait, kMany), Method::Direct);
    EXPECT_EQ(chosen(portrait, kFew), Method::Instanced);
    EXPECT_EQ(chosen(slanted, kMany), Method::Instanced);
    EXPECT_EQ(chosen(slanted, 200'000), Method::Direct);
}

TEST(SceneMethod, WhatIsAskedForIsDoneWhereItCanBe) {
    const auto portrait = displayOf(48);
    for (const Method method : {Method::Multipass, Method::Geometry, Method::Layered,
                                Method::Hybrid, Method::Direct, Method::Instanced})
        EXPECT_EQ(sceneMethod(method, SceneShading::PerPixel, portrait, kFew), method);
    for (const Method method : {Method::Hybrid, Method::Direct, Method::Auto})
        EXPECT_EQ(sceneMethod(method, SceneShading::PerVertex, portrait, kMany), Method::Instanced);
    const auto itself = displayOf(9, calib::DepthFrame{});
    EXPECT_EQ(sceneMethod(Method::Direct, SceneShading::PerPixel, itself, kMany),
              Method::Instanced);
    EXPECT_EQ(sceneMethod(Method::Hybrid, SceneShading::PerPixel, itself, kMany), Method::Hybrid);
}

} // namespace
} // namespace autostereo::gpu
