#include "daemon/command_line.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

namespace autostereo::daemon {
namespace {

CommandLine parse(const std::vector<std::string>& words) {
    std::vector<const char*> argv{"autostereo"};
    for (const std::string& word : words)
        argv.push_back(word.c_str());
    return parseCommandLine(static_cast<int>(argv.size()), argv.data());
}

/// Words after a `render` that is otherwise whole.
CommandLine parseRender(const std::vector<std::string>& more) {
    std::vector<std::string> words{"render", "--as", "view", "--output", "o.png"};
    words.insert(words.end(), more.begin(), more.end());
    return parse(words);
}

template<class Parse>
std::string messageFor(Parse parseWords) {
    try {
        parseWords();
    } catch (const UsageError& error) {
        return error.what();
    }
    return "no error";
}

std::string usageError(const std::vector<std::string>& words) {
    return messageFor([&] { (void)parse(words); });
}

std::string renderError(const std::vector<std::string>& more) {
    return messageFor([&] { (void)parseRender(more); });
}

TEST(CommandLine, RunTakesEveryOption) {
    const auto run = std::get<RunOptions>(
        parse({"run",      "--input", "a.mkv",      "--display", "preview",  "--rig",    "r.toml",
               "--config", "c.toml",  "--output",   "offscreen", "--force",  "--frames", "30",
               "--speed",  "max",     "--snapshot", "s.png",     "--report", "r.json"}));
    EXPECT_EQ(run.scene.input, "a.mkv");
    EXPECT_EQ(run.scene.display, "preview");
    EXPECT_EQ(run.scene.rig, "r.toml");
    EXPECT_EQ(run.scene.config, "c.toml");
    EXPECT_EQ(run.output, config::Output::Offscreen);
    EXPECT_TRUE(run.force);
    EXPECT_EQ(run.frames, 30U);
    EXPECT_EQ(run.speed, config::Speed::Max);
    EXPECT_EQ(run.snapshot, "s.png");
    EXPECT_EQ(run.report, "r.json");
    const auto other =
        std::get<RunOptions>(parse({"run", "--output", "window", "--speed=realtime"}));
    EXPECT_EQ(other.output, config::Output::Window);
    EXPECT_EQ(other.speed, config::Speed::Realtime);
}

TEST(CommandLine, RunLeavesTheRestToTheConfiguration) {
    const auto run = std::get<RunOptions>(parse({"run"}));
    EXPECT_FALSE(run.scene.input || run.scene.display || run.scene.rig || run.scene.config);
    EXPECT_FALSE(run.output || run.frames || run.speed || run.snapshot || run.report);
    EXPECT_FALSE(run.force);
}

TEST(CommandLine, RequestsToARunningProgram) {
    const auto options = [](const std::vector<std::string>& words) {
        return std::get<ControlOptions>(parse(words));
    };
    const ControlOptions status = options({"status", "--json", "--socket", "s.sock"});
    EXPECT_TRUE(std::holds_alternative<StatusRequest>(status.request));
    EXPECT_TRUE(status.json);
    EXPECT_EQ(status.socket, "s.sock");
    const ControlOptions snapshot = options({"snapshot", "p.png"});
    EXPECT_TRUE(std::holds_alternative<SnapshotRequest>(snapshot.request));
    EXPECT_EQ(snapshot.output, "p.png");
    EXPECT_FALSE(snapshot.socket);
    EXPECT_TRUE(std::holds_alternative<ReloadRequest>(options({"reload"}).request));
    const auto set = std::get<SetRequest>(options({"set", "scale=a=b"}).request);
    EXPECT_EQ(set.name, "scale");
    EXPECT_EQ(set.value, "a=b");
    EXPECT_EQ(std::get<ShowRequest>(options({"show", "live"}).request).what, "live");
    EXPECT_EQ(usageError({"set", "scale"}), "set: scale is no KEY=VALUE");
    EXPECT_EQ(usageError({"set", "=1"}), "set: =1 is no KEY=VALUE");
    for (const char* command : {"snapshot", "set", "show"})
        EXPECT_NE(usageError({command}).find("required"), std::string::npos) << command;
}

TEST(CommandLine, RenderTakesEveryOption) {
    const auto render = std::get<RenderOptions>(
        parse({"render", "--input", "sim:room", "--display", "d.toml", "--rig", "r.toml",
               "--config", "c.toml", "--frame", "12", "--method", "multipass", "--as", "quilt",
               "--output", "q.png"}));
    EXPECT_EQ(render.scene.input, "sim:room");
    EXPECT_EQ(render.scene.display, "d.toml");
    EXPECT_EQ(render.scene.rig, "r.toml");
    EXPECT_EQ(render.scene.config, "c.toml");
    EXPECT_EQ(render.frame, 12U);
    EXPECT_EQ(render.method, gpu::Method::Multipass);
    EXPECT_EQ(render.as, Picture::Quilt);
    EXPECT_EQ(render.output, "q.png");
    EXPECT_EQ(std::get<RenderOptions>(parseRender({"--method", "instanced"})).method,
              gpu::Method::Instanced);
}

TEST(CommandLine, RenderKnowsEachPicture) {
    const std::pair<const char*, Picture> pictures[] = {{"panel", Picture::Panel},
                                                        {"quilt", Picture::Quilt},
                                                        {"views", Picture::Views},
                                                        {"view", Picture::View},
                                                        {"depth", Picture::Depth}};
    for (const auto& [word, picture] : pictures) {
        const auto render =
            std::get<RenderOptions>(parse({"render", "--as", word, "--output", "o"}));
        EXPECT_EQ(render.as, picture);
        EXPECT_EQ(render.frame, 0U);
        EXPECT_FALSE(render.method || render.eye || render.cameraOffset);
        EXPECT_FALSE(render.scene.input || render.scene.display);
    }
}

TEST(CommandLine, RenderTakesPlacesAsXyz) {
    EXPECT_EQ(std::get<RenderOptions>(parseRender({"--eye", "0.1,0,0.5"})).eye,
              (glm::dvec3{0.1, 0, 0.5}));
    EXPECT_EQ(std::get<RenderOptions>(parseRender({"--eye", "-0.1,-2e-2,0.5"})).eye,
              (glm::dvec3{-0.1, -0.02, 0.5}));
    EXPECT_EQ(std::get<RenderOptions>(parseRender({"--eye=0,0,1"})).eye, (glm::dvec3{0, 0, 1}));
    EXPECT_EQ(std::get<RenderOptions>(parseRender({"--camera-offset", "-0.1,0,-0.5"})).cameraOffset,
              (glm::dvec3{-0.1, 0, -0.5}));
}

TEST(CommandLine, CheckAndDevices) {
    EXPECT_EQ(std::get<CheckOptions>(parse({"check", "a.toml", "b.mkv"})).files,
              (std::vector<std::filesystem::path>{"a.toml", "b.mkv"}));
    EXPECT_FALSE(std::get<DevicesOptions>(parse({"devices"})).json);
    EXPECT_EQ(std::get<DevicesOptions>(parse({"devices"})).root, "/");
    EXPECT_TRUE(std::get<DevicesOptions>(parse({"devices", "--json"})).json);
    EXPECT_EQ(std::get<DevicesOptions>(parse({"devices", "--root", "/tmp/x"})).root, "/tmp/x");
}

TEST(CommandLine, CalibrateNoise) {
    const auto noise = std::get<CalibrateNoiseOptions>(
        parse({"calibrate", "noise", "--input", "a.mkv", "--frames", "9", "--output", "n.toml"}));
    EXPECT_EQ(noise.input, "a.mkv");
    EXPECT_EQ(noise.frames, 9U);
    EXPECT_EQ(noise.output, "n.toml");
    EXPECT_FALSE(noise.json);
    EXPECT_NE(usageError({"calibrate"}), "");
    EXPECT_NE(usageError({"calibrate", "noise", "--input", "a", "--frames", "2", "--output", "n"}),
              "");
    EXPECT_NE(std::get<Information>(parse({"calibrate", "noise", "--help"})).text.find("--frames"),
              std::string::npos);
}

TEST(CommandLine, UnknownWordsAreNamedWithWhatIsAllowed) {
    EXPECT_EQ(usageError({"run", "--output", "tv"}),
              "--output: tv is not known (allowed offscreen, window)");
    EXPECT_EQ(usageError({"run", "--speed", "fast"}),
              "--speed: fast is not known (allowed max, realtime)");
    EXPECT_EQ(usageError({"render", "--as", "photo", "--output", "o"}),
              "--as: photo is not known (allowed 2d-plus-depth, anaglyph, depth, disparity, panel, "
              "quilt, sbs, view, views)");
    EXPECT_EQ(renderError({"--method", "magic"}),
              "--method: magic is not known (allowed auto, direct, "
              "geometry, hybrid, instanced, mrt, multipass)");
}

TEST(CommandLine, BadPlacesAreNamed) {
    EXPECT_EQ(renderError({"--eye", "nan,0,0.5"}), "--eye: nan is not a length in metres");
    EXPECT_EQ(renderError({"--eye", "0,inf,0.5"}), "--eye: inf is not a length in metres");
    EXPECT_EQ(renderError({"--camera-offset", "0,0,nan"}),
              "--camera-offset: nan is not a length in metres");
    for (const char* behind : {"0,0,0", "0,0,-0"})
        EXPECT_NE(renderError({"--eye", behind}).find("is not in front of the panel (allowed > 0)"),
                  std::string::npos);
    EXPECT_EQ(renderError({"--eye", "0,0,-0.5"}),
              "--eye: Z = -0.500000 is not in front of the panel (allowed > 0)");
    EXPECT_EQ(renderError({"--eye", "0,0,1", "--camera-offset", "0,0,0"}),
              "--eye and --camera-offset exclude each other");
    for (const char* option : {"--eye", "--camera-offset"})
        EXPECT_EQ(usageError({"render", "--as", "panel", "--output", "o", option, "0,0,1"}),
                  "--eye and --camera-offset go with --as view");
}

TEST(CommandLine, WhatCannotBeReadIsOneLineAndNamesTheOption) {
    const std::pair<std::vector<std::string>, const char*> cases[] = {
        {{"run", "--frames", "0"}, "--frames"},
        {{"run", "--frames", "-1"}, "--frames"},
        {{"run", "--frames", "ten"}, "--frames"},
        {{"run", "--frames"}, "--frames"},
        {{"run", "--nonsense"}, "--nonsense"},
        {{"run", "leftover"}, "leftover"},
        {{"render", "--output", "o"}, "--as"},
        {{"render", "--as", "view"}, "--output"},
        {{"render", "--as", "view", "--output", "o", "--frame", "-1"}, "--frame"},
        {{"render", "--as", "view", "--output", "o", "--frame", "1.5"}, "--frame"},
        {{"render", "--as", "view", "--output", "o", "--eye", "0,1"}, "--eye"},
        {{"render", "--as", "view", "--output", "o", "--eye", "0,0,1,2"}, "--eye"},
        {{"render", "--as", "view", "--output", "o", "--eye", "a,b,c"}, "--eye"},
        {{"render", "--as", "view", "--output", "o", "--eye"}, "--eye"},
        {{"check"}, "files"},
        {{"devices", "--xml"}, "--xml"},
        {{"fly"}, "fly"},
    };
    for (const auto& [words, named] : cases) {
        const std::string message = usageError(words);
        EXPECT_NE(message.find(named), std::string::npos) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_NE(message.find("(see autostereo --help)"), std::string::npos) << message;
    }
}

TEST(CommandLine, NoCommandSaysWhichThereAre) {
    EXPECT_EQ(
        usageError({}),
        "no command given (run, record, render, interleave, viewmap, look, pattern, import, "
        "calibrate, check, devices, bench, latency, status, snapshot, reload, set, show): see "
        "autostereo --help");
}

TEST(CommandLine, HelpShowsAnExampleForEachCommand) {
    for (const std::string command :
         {"run", "render", "interleave", "viewmap", "pattern", "import", "check", "devices",
          "status", "snapshot", "reload", "set", "show"}) {
        const std::string help = std::get<Information>(parse({command, "--help"})).text;
        EXPECT_NE(help.find("Example: autostereo " + command + " "), std::string::npos) << help;
    }
    const std::string all = std::get<Information>(parse({"--help"})).text;
    for (const char* command : {"run", "render", "check", "devices"})
        EXPECT_NE(all.find(std::string("\n  ") + command + " "), std::string::npos) << all;
}

TEST(CommandLine, ExamplesAreGoodCommandLines) {
    for (const std::string command : {"run", "render", "check", "devices"}) {
        const std::string help = std::get<Information>(parse({command, "-h"})).text;
        const std::string start = "Example: autostereo ";
        std::istringstream example(help.substr(help.find(start) + start.size()));
        std::vector<std::string> words;
        for (std::string word; example >> word;)
            words.push_back(word);
        EXPECT_EQ(usageError(words), "no error") << command;
    }
}

TEST(CommandLine, VersionIsOneLine) {
    const std::string text = std::get<Information>(parse({"--version"})).text;
    EXPECT_EQ(text.rfind("autostereo ", 0), 0U) << text;
    EXPECT_EQ(text.find('\n'), text.size() - 1);
}

} // namespace
} // namespace autostereo::daemon
