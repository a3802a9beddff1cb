// Every program with every set of defines that the passes use compiles and links.

#include "gpu/gl/program.hpp"
#include "tests/support/gl_fixture.hpp"

namespace autostereo::test {
namespace {

struct Variant {
    std::vector<std::string> shaders;
    std::vector<std::string> defines;
};

void PrintTo(const Variant& variant, std::ostream* out) { // NOLINT(readability-identifier-naming)
    *out << variant.shaders.back();
    for (const std::string& define : variant.defines)
        *out << ' ' << define;
}

class ProgramsGlTest : public GlTest, public testing::WithParamInterface<Variant> {};

TEST_P(ProgramsGlTest, Links) {
    EXPECT_NO_THROW(gpu::gl::Program(GetParam().shaders, GetParam().defines));
}

INSTANTIATE_TEST_SUITE_P(
    All, ProgramsGlTest,
    testing::Values(
        Variant{{"condition_measure.comp"}, {}}, Variant{{"condition_flying.comp"}, {}},
        Variant{{"condition_hold.comp"}, {}}, Variant{{"condition_holes.comp"}, {}},
        Variant{{"condition_fills.comp"}, {}}, Variant{{"condition_fills.comp"}, {"RESET"}},
        Variant{{"mesh_points.comp"}, {}}, Variant{{"mesh_indices.comp"}, {}},
        Variant{{"mesh_footprint.comp"}, {}}, Variant{{"mesh_bounds.comp"}, {}},
        Variant{{"mesh_pick.comp"}, {}}, Variant{{"mesh_pick.comp"}, {"LIST"}},
        Variant{{"cleared_blocks.vert", "cleared_blocks.frag"}, {}},
        Variant{{"depth_statistics.comp"}, {}}, Variant{{"color_converter.comp"}, {"YUYV"}},
        Variant{{"color_converter.comp"}, {"UYVY"}}, Variant{{"color_converter.comp"}, {"NV12"}},
        Variant{{"color_converter.comp"}, {"GREY"}}, Variant{{"color_converter.comp"}, {"RGB"}},
        Variant{{"color_converter.comp"}, {"BGR"}},
        Variant{{"color_converter.comp"}, {"YUYV", "MARKS"}},
        Variant{{"color_converter.comp"}, {"UYVY", "MARKS"}},
        Variant{{"color_converter.comp"}, {"NV12", "MARKS"}},
        Variant{{"color_converter.comp"}, {"GREY", "MARKS"}},
        Variant{{"color_converter.comp"}, {"RGB", "MARKS"}},
        Variant{{"color_converter.comp"}, {"BGR", "MARKS"}},
        Variant{{"mesh_cyclopean.vert", "mesh_depth.frag"}, {}}, Variant{{"edge_band.comp"}, {}},
        Variant{{"fill_holes.comp"}, {}}, Variant{{"background_claims.comp"}, {}},
        Variant{{"background_remember.comp"}, {}}, Variant{{"background_guide.comp"}, {}},
        Variant{{"background_seeds.comp"}, {}}, Variant{{"background_compose.comp"}, {}},
        Variant{{"pull.comp"}, {}}, Variant{{"push.comp"}, {}},
        Variant{{"push.comp"}, {"COARSEST"}}, Variant{{"push.comp"}, {"COARSEST", "HELD"}},
        Variant{{"push.comp"}, {"GUIDE"}}, Variant{{"push.comp"}, {"HIDDEN"}},
        Variant{{"list_blocks.comp"}, {}}, Variant{{"unmark_blocks.comp"}, {}},
        Variant{{"background_tally.comp"}, {}}, Variant{{"background_tally.comp"}, {"RESET"}},
        Variant{{"background_tally.comp"}, {"MOVED"}}, Variant{{"picture_marks.comp"}, {}},
        Variant{{"picture_marks.comp"}, {"BOUNDS"}}, Variant{{"layer_quads.comp"}, {}},
        Variant{{"layer_nodes.comp"}, {}}, Variant{{"mesh_view.vert", "mesh_view.frag"}, {}},
        Variant{{"mesh_view.vert", "mesh_view.frag"}, {"TILED"}},
        Variant{{"mesh_eye.vert", "mesh_view.frag"}, {}},
        Variant{{"mesh_camera.vert", "mesh_view.frag"}, {"CUBIC"}},
        Variant{{"register_mesh.comp"}, {}}, Variant{{"register_cuts.comp"}, {}},
        Variant{{"register_cuts.comp"}, {"EXTRUDE"}}, Variant{{"mesh_points.comp"}, {"PLACES"}},
        Variant{{"full_screen.vert", "register_metres.frag"}, {}},
        Variant{{"quad_corners.comp"}, {}}, Variant{{"search_blocks.comp"}, {}},
        Variant{{"mesh_view.vert", "mesh_views.geom", "mesh_view.frag"}, {"REPEATED", "VIEWS 8"}},
        Variant{{"mesh_view.vert", "mesh_views.geom", "mesh_view.frag"},
                {"REPEATED", "LAYERED", "VIEWS 8"}},
        Variant{{"mesh_view.vert", "mesh_reference.frag"}, {"DISPARITY"}},
        Variant{{"full_screen.vert", "hybrid_views.frag"}, {}},
        Variant{{"full_screen.vert", "view_interleaver.frag"}, {"SEARCH", "REMAP", "GRID"}},
        Variant{{"full_screen.vert", "view_interleaver.frag"}, {"SEARCH", "CONTINUOUS"}},
        Variant{{"stale_tiles.vert", "view_interleaver.frag"}, {"SEARCH", "ROOTS", "REMAP"}},
        Variant{{"stale_tiles.vert", "view_interleaver.frag"}, {"SEARCH", "ROOTS", "CONTINUOUS"}},
        Variant{{"stale_tiles.vert", "kept_roots.frag"}, {}}, Variant{{"stale_tiles.comp"}, {}},
        Variant{{"stale_tiles.comp"}, {"UPSIDE_DOWN"}},
        Variant{{"full_screen.vert", "tile_interleaver.frag"}, {"SEARCH"}},
        Variant{{"full_screen.vert", "band_interleaver.frag"}, {"SEARCH", "WAVEFORM"}},
        Variant{{"mesh_view.vert", "mesh_disparity.frag"}, {"DISPARITY"}}));

std::vector<Variant> interleavers() {
    std::vector<Variant> variants{
        {{"full_screen.vert", "depth_frame.frag"}, {}},
        {{"full_screen.vert", "depth_frame.frag"}, {"HEADER"}},
        {{"full_screen.vert", "tile_interleaver.frag"}, {}},
        {{"full_screen.vert", "tile_interleaver.frag"}, {"NEAREST"}},
        {{"full_screen.vert", "band_interleaver.frag"}, {}},
        {{"full_screen.vert", "band_interleaver.frag"}, {"WAVEFORM", "GRID", "FRINGE"}},
        {{"full_screen.vert", "view_interleaver.frag"}, {"PATTERN", "REVERSED"}},
        {{"full_screen.vert", "view_interleaver.frag"}, {"UPSIDE_DOWN", "FRINGE"}}};
    const std::vector<std::string> switches{"LUT", "CELLS", "GRID", "REMAP", "NEAREST", "BLEND"};
    for (unsigned set = 0; set < 1U << switches.size(); ++set) {
        Variant variant{{"full_screen.vert", "view_interleaver.frag"}, {}};
        for (std::size_t bit = 0; bit < switches.size(); ++bit)
            if ((set >> bit & 1U) != 0) variant.defines.push_back(switches[bit]);
        variants.push_back(variant);
    }
    return variants;
}

std::vector<Variant> scenes() {
    std::vector<Variant> variants{{{"scene_view.vert", "scene_view.frag"}, {"DISPARITY"}}};
    for (const char* shading : {"PLAIN", "TEXTURED", "PER_VERTEX", "PER_PIXEL"}) {
        variants.push_back({{"scene_view.vert", "scene_view.frag"}, {shading}});
        variants.push_back({{"scene_view.vert", "scene_view.frag"}, {shading, "TILED"}});
        for (const char* target : {"TILES", "LAYERED"})
            variants.push_back({{"scene_view.vert", "scene_view.geom", "scene_view.frag"},
                                {shading, target, "REPEATED", "VIEWS 8"}});
    }
    for (const char* shading : {"PLAIN", "TEXTURED", "PER_PIXEL"}) {
        variants.push_back(
            {{"scene_view.vert", "scene_view.frag"}, {shading, "DISPARITY", "SURFACES"}});
        variants.push_back({{"full_screen.vert", "scene_resolve.frag"}, {shading}});
        for (const char* eyes : {"REMAP", "CONTINUOUS"})
            variants.push_back({{"full_screen.vert", "view_interleaver.frag"},
                                {"SEARCH", "SURFACES", shading, eyes, "GRID"}});
        for (const char* panel : {"tile_interleaver.frag", "band_interleaver.frag"})
            variants.push_back({{"full_screen.vert", panel}, {"SEARCH", "SURFACES", shading}});
    }
    variants.push_back({{"stale_tiles.vert", "view_interleaver.frag"},
                        {"SEARCH", "SURFACES", "PER_PIXEL", "UPSIDE_DOWN"}});
    variants.push_back({{"full_screen.vert", "scene_reproject.frag"}, {}});
    variants.push_back({{"line_screen.vert", "line_screen.frag"}, {}});
    variants.push_back({{"scene_peaks.comp"}, {}});
    variants.push_back({{"scene_tiles.comp"}, {}});
    variants.push_back({{"scene_tiles.comp"}, {"UPSIDE_DOWN"}});
    return variants;
}

INSTANTIATE_TEST_SUITE_P(Scenes, ProgramsGlTest, testing::ValuesIn(scenes()));
INSTANTIATE_TEST_SUITE_P(Interleavers, ProgramsGlTest, testing::ValuesIn(interleavers()));

class ProgramGlTest : public GlTest {};

TEST_F(ProgramGlTest, AFaultNamesTheShaderAndShowsItsLines) {
    try {
        const gpu::gl::Program program({"mesh_points.comp"}, {"imageStore missingFunction"});
        FAIL() << "a shader with an unknown function linked";
    } catch (const gpu::GlError& error) {
        forgiveErrors();
        const std::string what = error.what();
        EXPECT_NE(what.find("mesh_points.comp"), std::string::npos) << what;
        EXPECT_NE(what.find("2: #define imageStore missingFunction"), std::string::npos) << what;
    }
}

} // namespace
} // namespace autostereo::test
