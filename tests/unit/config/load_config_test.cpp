#include "config/load.hpp"
#include "tests/support/data.hpp"
#include "tests/unit/config/same_config.hpp"
#include "tests/unit/config/temp_folder.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <numbers>
#include <string>

using namespace std::chrono_literals;

namespace autostereo::config {
namespace {

class LoadConfig : public test::TempFolder {};

// The shipped file must give every key (its loader refuses fallbacks) and say what the code says.
TEST_F(LoadConfig, defaultFileGivesTheDefaultsOfTheStructs) {
    expectSame(defaultConfig(), Config{});
}

TEST_F(LoadConfig, emptyFileChangesNothing) {
    write("empty.toml", "");
    expectSame(loadConfig("empty.toml"), defaultConfig());
}

TEST_F(LoadConfig, everyKeyArrives) {
    write("all.toml", R"([input]
uri = "kitchen.mkv"
rig = "site.toml"
wait = "yes"
[display]
profile = "barrier-5view"
[output]
kind = "offscreen"
refresh_hz = 59.94
[sync]
tolerance_ms = 7.5
[reconnect]
first_delay_ms = 50
longest_delay_ms = 60
[condition]
validity = false
weakest_amplitude = 7
saturated_amplitude = 4000
confidence = false
noise_floor_mm = 0.5
noise_shot_mm = 200
noise_growth_mm = 2
flying_pixels = false
grazing_deg = 80
edge_sigmas = 4.5
hold = false
gate_sigmas = 6
settle_frames = 8
keep_frames = 0
fill_holes = false
hole_width = 5
color_noise_levels = 2.5
[mesh]
nearest_m = 0.3
farthest_m = 4
cut_ratio = 0.1
[registration]
extrude_px = 3
[depth]
focus_m = 1.25
scale = 0.5
follow = "always"
focus_range_m = [0.5, 3]
scale_range = [0, 2]
near_percent = 1
subject_percent = 50
far_percent = 80
time_constant_s = 4
dead_band = 0.2
[framing]
mounting_deg = 270
mirror = true
zoom = 2
pan = [-0.5, 1]
far_cut_m = 2.5
backdrop_color = [0, 1, 0.2]
[synthesis]
method = "multipass"
filter = "nearest"
skip_unchanged = false
[picture]
clear_color = [0.1, 0, 1]
brightness = 0.25
mode = "2d"
[viewer]
source = "file:walk.csv"
delay_ms = 12.5
eye_spacing_mm = 60
lost_after_ms = 300
ease_ms = 250
cutoff_hz = 1
cutoff_per_speed = 2
velocity_cutoff_hz = 3
rest_speed = 0.5
origin_mm = [10, 250, -20]
rotation_deg = [0, 180, 0]
axis_scale = [-1, 1, 1]
angle_scale = [0, 0, -1]
camera_fov_deg = 90
[rest]
hours = ["mon-fri 09:00-18:00", "sun 20:00-02:00"]
presence_m = 1.5
presence_percent = 25
leave_s = 0.5
monitor_off_s = 90

[idle]
freeze_s = 2.5
content = "idle.glb"
[messages]
starting = "a"
no_input = "b"
depth_lost = "c"
color_lost = "d"
both_lost = "e"
no_pairs = ""
[control]
socket = "/run/kiosk.sock"
group = "museum"
[record]
ring_s = 12.5
ring_mib = 64
[http]
listen = "192.168.1.5:80"
allow_remote = true
token_file = "/etc/token"
[log]
level = "trace"
)");
    Config expected;
    expected.input = "kitchen.mkv";
    expected.rig = "site.toml";
    expected.display = "barrier-5view";
    expected.output = Output::Offscreen;
    expected.refreshHz = 59.94;
    expected.sync.tolerance = 7500us;
    expected.reconnect = {50ms, 60ms};
    const calib::DepthNoise noise{0.0005, 0.2, 0.002};
    expected.pipeline.condition = {
        false, 7,     4000, false, noise, false, 80 * std::numbers::pi / 180,
        4.5,   false, 6,    8,     0,     false, 5};
    expected.pipeline.mesh = {0.3, 4, 0.1};
    expected.pipeline.registration = {3};
    expected.pipeline.budget = {1.25, 0.5, false, {0.5, 3, 0, 2}, {4, 0.2}, 0.01, 0.8, 0.5};
    expected.depthFollows = Following::Always;
    expected.pipeline.framing = {3, true, 2, {-0.5, 1}};
    expected.pipeline.backdrop = {2.5, 1, 1, {0, 255, 51, 255}};
    expected.pipeline.synthesis = {gpu::Method::Multipass, gpu::TileFilter::Nearest};
    expected.pipeline.skipUnchanged = false;
    expected.pipeline.color.sigma = 2.5;
    expected.pipeline.clearColor = {0.1, 0, 1};
    expected.wait = true;
    expected.brightness = 0.25;
    expected.flat = true;
    expected.viewer = {
        "file:walk.csv",
        12500us,
        0.06,
        {1, 2, 3, 0.5},
        300ms,
        250ms,
        {glm::dvec3{0.01, 0.25, -0.02}, {0, std::numbers::pi, 0}, {-1, 1, 1}, {0, 0, -1}},
        std::nullopt,
        std::numbers::pi / 2};
    expected.idle = {2500ms, "idle.glb", "a", "b", "c", "d", "e", ""};
    expected.rest = {{{0x1F, 540, 1080}, {0x40, 1200, 120}}, 1.5, 0.25, 500ms, 90s};
    expected.control = {"/run/kiosk.sock", "museum"};
    expected.ring = {12500ms, std::size_t{64} << 20U};
    expected.http = {ListenAddress{"192.168.1.5", 80, false}, "/etc/token"};
    expected.log.level = "trace";
    expectSame(loadConfig("all.toml"), expected);
}

TEST_F(LoadConfig, filesAreLookedForBesideTheirConfiguration) {
    std::filesystem::create_directory("site");
    write("site/all.toml", "[input]\nrig = 'rig.toml'\n[display]\nprofile = 'mine.toml'\n");
    EXPECT_EQ(loadConfig("site/all.toml").rig, "site/rig.toml");
    EXPECT_EQ(loadConfig("site/all.toml").display, "site/mine.toml");
    write("site/page.toml", "[http]\ntoken_file = 'token'\n");
    EXPECT_EQ(loadConfig("site/page.toml").http.tokenFile, "site/token");
    write("site/eyes.toml", "[viewer]\nsource = 'file:walk.csv'\n");
    EXPECT_EQ(loadConfig("site/eyes.toml").viewer.source, "file:site/walk.csv");
    write("site/webcam.toml",
          "version = 1\nprovenance = 'a test'\n[color]\nwidth = 640\nheight = 480\n"
          "fx = 554\nfy = 555\ncx = 319\ncy = 241\n");
    write("site/seen.toml", "[viewer]\ncamera_rig = 'webcam.toml'\n");
    const auto camera = loadConfig("site/seen.toml").viewer.camera;
    ASSERT_TRUE(camera);
    EXPECT_EQ(camera->intrinsics.fy, 555);
    write("site/other.toml", "[input]\nrig = '/etc/rig.toml'\n[display]\nprofile = 'preview'\n");
    EXPECT_EQ(loadConfig("site/other.toml").rig, "/etc/rig.toml");
    EXPECT_EQ(loadConfig("site/other.toml").display, "preview");
}

struct MalformedConfig {
    const char* text;
    const char* message;
};

constexpr MalformedConfig kMalformedConfigs[] = {
    {"[viewer]\norigin_mm = [1, 2]\n",
     "x.toml:2:13: viewer.origin_mm: is no place (allowed [] or [x, y, z])"},
    {"[viewer]\neye_spacing_mm = 0.063\n",
     "x.toml:2:18: viewer.eye_spacing_mm: 0.063 is out of range (allowed 30 to 90)"},
    {"[viewer]\ncamera_fov_deg = 180\n",
     "x.toml:2:18: viewer.camera_fov_deg: 180 is out of range (allowed 0 to 170)"},
    {"[mesh]\ncut_ratio = 1.5\n",
     "x.toml:2:13: mesh.cut_ratio: 1.5 is out of range (allowed 0.005 to 0.5)"},
    {"[mesh]\ncut_ratoi = 0.1\n",
     "x.toml:2:1: mesh.cut_ratoi: unknown key (did you mean cut_ratio?)"},
    {"\n[meshes]\ncut_ratio = 0.1\n", "x.toml:2:2: meshes: unknown key (did you mean mesh?)"},
    {"[log]\nlevel = 'info'\ncolour_scheme = 3\n", "x.toml:3:1: log.colour_scheme: unknown key"},
    {"[mesh]\n\"cut_ratio\\n\" = 1\n",
     "x.toml:2:1: mesh.cut_ratio?: unknown key (did you mean cut_ratio?)"},
    {"\"mesh.cut_ratio\" = 0.1\n", "x.toml:1:1: mesh.cut_ratio: unknown key"},
    {"mesh = 3\n", "x.toml:1:8: mesh: is an integer, wanted a table"},
    {"[[mesh]]\ncut_ratio = 0.1\n", "x.toml:1:1: mesh: is an array, wanted a table"},
    {"[mesh]\ncut_ratio = '5%'\n", "x.toml:2:13: mesh.cut_ratio: is a string, wanted "
                                   "a number (allowed 0.005 to 0.5)"},
    {"[mesh]\nnearest_m = nan\n",
     "x.toml:2:13: mesh.nearest_m: nan is no finite number (allowed 0.01 to 10)"},
    {"[mesh]\nfarthest_m = inf\n",
     "x.toml:2:14: mesh.farthest_m: inf is no finite number (allowed 0.1 to 100)"},
    {"[mesh]\nnearest_m = 5\nfarthest_m = 5\n",
     "x.toml:3:14: mesh.farthest_m: is not farther than nearest_m (allowed nearest_m "
     "to 100)"},
    {"[condition]\nweakest_amplitude = 300\nsaturated_amplitude = 300\n",
     "x.toml:3:23: condition.saturated_amplitude: is not more than weakest_amplitude (allowed "
     "weakest_amplitude to 65535)"},
    {"[condition]\nhole_width = 9\n",
     "x.toml:2:14: condition.hole_width: 9 is out of range (allowed 0 to 8)"},
    {"[condition]\nhold = 1\n", "x.toml:2:8: condition.hold: is an integer, wanted true or false"},
    {"[reconnect]\nfirst_delay_ms = 9000\n",
     "x.toml:1:1: reconnect.longest_delay_ms: is less than first_delay_ms (allowed "
     "first_delay_ms to 600000)"},
    {"[sync]\ntolerance_ms = -1\n",
     "x.toml:2:16: sync.tolerance_ms: -1 is out of range (allowed 0 to 1000)"},
    {"[depth]\nfocus_m = 'near'\n", "x.toml:2:11: depth.focus_m: is a string, wanted "
                                    "\"auto\" or a number (allowed 0.05 to 100)"},
    {"[depth]\nscale = 1979-05-27\n",
     "x.toml:2:9: depth.scale: is a date, wanted \"auto\" or a number (allowed 0 to 10)"},
    {"[depth]\nscale_range = [1, 0.5]\n",
     "x.toml:2:15: depth.scale_range: ends before it begins (allowed [least, most])"},
    {"[depth]\nfocus_range_m = [0, 2]\n",
     "x.toml:2:18: depth.focus_range_m: 0 is out of range (allowed 0.05 to 100)"},
    {"[depth]\nfar_percent = 4\n", "x.toml:2:15: depth.far_percent: is less than near_percent "
                                   "(allowed near_percent to 100)"},
    {"[framing]\nmounting_deg = 45\n",
     "x.toml:2:16: framing.mounting_deg: 45 is no quarter turn (allowed 0, 90, 180, 270)"},
    {"[framing]\nzoom = 0.5\n", "x.toml:2:8: framing.zoom: 0.5 is out of range (allowed 1 to 20)"},
    {"[framing]\npan = [0, 1.5]\n",
     "x.toml:2:11: framing.pan: 1.5 is out of range (allowed -1 to 1)"},
    {"[framing]\nbackdrop_picture = 'nowhere.png'\n",
     "x.toml:2:20: framing.backdrop_picture: cannot read nowhere.png: No such file or directory"},
    {"[depth]\nfollow = true\n", "x.toml:2:10: depth.follow: is a boolean, wanted a word "
                                 "(allowed live, always, never)"},
    {"[synthesis]\nmethod = 'instanced '\n",
     "x.toml:2:10: synthesis.method: \"instanced \" is unknown (allowed auto, direct, "
     "instanced, multipass, geometry, mrt, hybrid)"},
    {"[output]\nkind = true\n", "x.toml:2:8: output.kind: is a boolean, wanted a word "
                                "(allowed auto, window, offscreen)"},
    {"[output]\nrefresh_hz = -60\n",
     "x.toml:2:14: output.refresh_hz: -60 is out of range (allowed 0 to 500)"},
    {"[input]\nuri = 7\n", "x.toml:2:7: input.uri: is an integer, wanted a string"},
    {"[picture]\nclear_color = [0, 0]\n",
     "x.toml:2:15: picture.clear_color: has 2 elements, wanted an array of 3 numbers "
     "(allowed 0 to 1)"},
    {"[picture]\nclear_color = [0, 0, 255]\n",
     "x.toml:2:22: picture.clear_color: 255 is out of range (allowed 0 to 1)"},
    {"[picture]\nclear_color = 'black'\n",
     "x.toml:2:15: picture.clear_color: is a string, wanted an array of 3 numbers "
     "(allowed 0 to 1)"},
    {"[idle]\nfreeze_s = 5\n", "x.toml:2:12: idle.freeze_s: 5 is out of range (allowed 0 to 4)"},
    {"[idle]\ncontent = 'idle.mp4'\n",
     "x.toml:2:11: idle.content: \"idle.mp4\" is of no kind that can be shown (allowed .png, .jpg, "
     ".jpeg, quilts ..._qs8x6a0.75.png, .mkv, .oni, .glb, .gltf, .obj, .ply)"},
    {"[input]\nwait = true\n",
     "x.toml:2:8: input.wait: is a boolean, wanted a word (allowed auto, yes, no)"},
    {"[http]\nlisten = 'localhost:8787'\n",
     "x.toml:2:10: http.listen: \"localhost:8787\" is no address with a port (allowed "
     "\"127.0.0.1:8787\", \"[::1]:8787\" or \"\")"},
    {"[http]\nlisten = '0.0.0.0:8787'\n",
     "x.toml:2:10: http.listen: \"0.0.0.0:8787\" can be reached from other machines (allowed with "
     "http.allow_remote = true)"},
    {"[record]\nring_mib = 0\n",
     "x.toml:2:12: record.ring_mib: 0 is out of range (allowed 1 to 768)"},
    {"[http]\nlisten = 8787\n", "x.toml:2:10: http.listen: is an integer, wanted a string"},
    {"[picture]\nmode = '4d'\n", "x.toml:2:8: picture.mode: \"4d\" is unknown (allowed 3d, 2d)"},
    // Of several problems the first in the file.
    {"[sync]\ntolerance_ms = 5000\n[mesh]\ncut_ratio = 1\n",
     "x.toml:2:16: sync.tolerance_ms: 5000 is out of range (allowed 0 to 1000)"},
    {"[log]\nlevel = \"info\n",
     "x.toml:2:14: syntax: Error while parsing string: unescaped control characters other than TAB "
     "(U+0009) are explicitly prohibited"}};

TEST_F(LoadConfig, malformedSaysWhatAndWhere) {
    for (const MalformedConfig& bad : kMalformedConfigs) {
        write("x.toml", bad.text);
        EXPECT_EQ(test::messageOf<ConfigError>([] { (void)loadConfig("x.toml"); }), bad.message);
    }
}

TEST_F(LoadConfig, kindOfGoesByContent) {
    const std::filesystem::path source = test::sourceDir() / "config";
    const std::filesystem::path displays = source / "displays";
    EXPECT_EQ(kindOf(source / "default.toml"), FileKind::Config);
    EXPECT_EQ(kindOf(source / "rigs/example.toml"), FileKind::Rig);
    for (const std::string& name : displayNames())
        EXPECT_EQ(kindOf(displays / (name + ".toml")), FileKind::Display) << name;
    write("camera.json", "{\"depth\": {}}");
    EXPECT_EQ(kindOf("camera.json"), FileKind::Rig);
    write("visual.json", "{\"pitch\": 5}");
    EXPECT_EQ(kindOf("visual.json"), FileKind::Display);
    write("empty.toml", "");
    EXPECT_EQ(kindOf("empty.toml"), FileKind::Config);
    write("broken.toml", "type =");
    EXPECT_THROW((void)kindOf("broken.toml"), ConfigError);
}

} // namespace
} // namespace autostereo::config
