#include "devices/content_kind.hpp"
#include "devices/quilt_name.hpp"

#include <gtest/gtest.h>

namespace autostereo::devices {
namespace {

TEST(ContentKind, FollowsTheFilesName) {
    using enum ContentKind;
    EXPECT_EQ(contentKind("/a b/castle.png"), Picture);
    EXPECT_EQ(contentKind("castle.JPG"), Picture);
    EXPECT_EQ(contentKind("castle_qs8x6a0.75.jpeg"), Quilt);
    EXPECT_EQ(contentKind("castle_qs4x2.png"), Quilt);
    EXPECT_EQ(contentKind("castle_qs.png"), Picture);
    EXPECT_EQ(contentKind("folder_qs4x2/castle.png"), Picture) << "folders say nothing";
    EXPECT_EQ(contentKind("visit_qs4x2.mkv"), Recording);
    EXPECT_EQ(contentKind("visit.oni"), Recording);
    for (const char* scene : {"a.glb", "a.gltf", "a.OBJ", "a.ply"})
        EXPECT_EQ(contentKind(scene), Scene) << scene;
    for (const char* other : {"", "png", "a", "a.mp4", "a.png.txt", "sim:person", "tum:folder"})
        EXPECT_EQ(contentKind(other), std::nullopt) << other;
}

TEST(ContentKind, AQuiltsNameSaysItsTiles) {
    const auto name = quiltName("my_qs1x1_qs8x6a0.75.png");
    ASSERT_TRUE(name);
    EXPECT_EQ(name->columns, 8);
    EXPECT_EQ(name->rows, 6);
    EXPECT_EQ(name->aspect, 0.75);
    EXPECT_EQ(quiltName("a_qs4x2.png")->aspect, std::nullopt);
    for (const char* none : {"a.png", "a_qs0x2.png", "a_qs4x101.png", "a_qs4.png", "a_qs-4x2.png"})
        EXPECT_FALSE(quiltName(none)) << none;
}

} // namespace
} // namespace autostereo::devices
