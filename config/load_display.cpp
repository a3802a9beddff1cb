#include "config/display_reader.hpp"
#include "config/load.hpp"
#include "config/phrases.hpp"
#include "config/text_file.hpp"
#include "config/units.hpp"
#include "config/vendor_calibration.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace autostereo::config {

namespace {

constexpr std::string_view kShippedFolder = "displays/";
constexpr std::string_view kExtension = ".toml";
constexpr std::string_view kCalibrationExtension = ".json";

/// How the types differ in what their files hold.
struct Type {
    std::string_view name;
    bool anyMode = false;   ///< panel.width = height = 0 is allowed
    bool multiview = false; ///< the file says how many views, their order and their fan
    bool optics = false;    ///< lenses or slits in front of the panel
};

constexpr std::array kTypes{
    Type{"linear", false, true, true},        Type{"van_berkel", false, true, true},
    Type{"looking_glass", false, true, true}, Type{"cubevi", false, true, true},
    Type{"table", false, true, true},         Type{"lut", false, true, true},
    Type{"line_screen", false, true, true},   Type{"two_view_tracked", false, true, true},
    Type{"quilt", true, true, false},         Type{"2d_plus_depth", false, false, false},
    Type{"side_by_side", true, false, false}, Type{"top_bottom", true, false, false},
    Type{"row", true, false, false},          Type{"column", true, false, false},
    Type{"checkerboard", true, false, false}, Type{"anaglyph", true, false, false},
    Type{"flat", true, false, false}};

Type readType(TomlReader& root) {
    std::vector<std::string_view> words;
    words.reserve(kTypes.size());
    for (const Type& type : kTypes)
        words.push_back(type.name);
    const auto index = root.wordIndex("type", words);
    root.check(); // which keys are known depends on it
    return kTypes.at(index.value_or(0));
}

void readPanel(DisplayReader& display, const Type& type) {
    auto& profile = display.profile;
    auto panel = display.root.table("panel");
    const Range pixels{type.anyMode ? 0 : kPanelPixels.low, kPanelPixels.high};
    profile.width = panel.integer("width", pixels);
    profile.height = panel.integer("height", pixels);
    if ((profile.width == 0) != (profile.height == 0))
        panel.reject("height", "must be 0 where width is, and only there");
    if (type.name != "looking_glass") // whose dpi says it
        profile.widthM = units::metresFromMm(display.physical(panel, "width_mm", {10, 20000}));
    if (panel.has("edid_names")) profile.edidNames = panel.words("edid_names", {1, 16});
}

void readRemap(DisplayReader& display, TomlReader& viewing) {
    if (!viewing.has("view_remap")) return;
    auto& profile = display.profile;
    for (const std::string& word : viewing.words("view_remap", {1, 1000})) {
        const bool number = !word.empty() && word.size() < 4 &&
                            word.find_first_not_of("0123456789") == std::string::npos;
        const int shown = word == "left"    ? 0
                          : word == "right" ? profile.views - 1
                          : word == "black" ? calib::DisplayProfile::kBlack
                          : number          ? std::stoi(word)
                                            : profile.views;
        if (shown >= profile.views)
            viewing.reject("view_remap", '"' + word +
                                             "\" is no view (allowed left, right, black, "
                                             "\"0\" to \"" +
                                             std::to_string(profile.views - 1) + "\")");
        profile.remap.push_back(shown);
    }
}

void readViewing(DisplayReader& display, const Type& type) {
    auto& profile = display.profile;
    auto viewing = display.root.table("viewing");
    profile.viewingDistanceM = display.physical(viewing, "distance_m", {0.05, 100});
    profile.coneRad = units::radiansFromDeg(display.physical(viewing, "cone_deg", kConeDeg));
    if (!type.multiview) return;
    profile.views = viewing.integer("views", {1, 1000});
    profile.order = viewing.choice<calib::ViewOrder>(
        "view_order", {{"left_to_right", calib::ViewOrder::LeftToRight},
                       {"right_to_left", calib::ViewOrder::RightToLeft}});
    profile.fan = viewing.choice<calib::Fan>(
        "fan", {{"centres", calib::Fan::Centres}, {"edges", calib::Fan::Edges}});
    if (profile.fan == calib::Fan::Edges && profile.views < 2)
        viewing.reject("fan", "\"edges\" needs two views or more (allowed centres)");
    readRemap(display, viewing);
}

void readOptics(DisplayReader& display, const Type& type) {
    using Kind = calib::Optics::Kind;
    if (!type.optics) return;
    auto& optics = display.profile.optics;
    const bool slit = type.name == "line_screen";
    optics.kind = slit ? Kind::Slit : type.name == "lut" ? Kind::None : Kind::Lens;
    if (!display.root.has("optics")) return;
    auto table = display.root.table("optics");
    optics.kind = table.choice<Kind>("kind", {{"lens", Kind::Lens}, {"slit", Kind::Slit}},
                                     slit ? Kind::Slit : Kind::Lens);
    if (table.has("gap_mm"))
        optics.gapM = units::metresFromMm(display.physical(table, "gap_mm", {0.001, 1000}));
    if (table.has("aperture")) optics.aperture = display.physical(table, "aperture", {0, 1});
}

calib::DisplayLaw readLaw(DisplayReader& display, const Type& type) {
    if (type.name == "linear") return readLinear(display);
    if (type.name == "van_berkel") return readVanBerkel(display);
    if (type.name == "looking_glass") return readLookingGlass(display);
    if (type.name == "cubevi") return readCubevi(display);
    if (type.name == "table") return readTable(display);
    if (type.name == "lut") return readLut(display);
    if (type.name == "line_screen") return readLineScreen(display);
    if (type.name == "two_view_tracked") return readTrackedLens(display);
    if (type.name == "2d_plus_depth") return readDepthFrame(display);
    return readFrame(display, type.name);
}

void readQuilt(DisplayReader& display) {
    constexpr int kLargestTexture = 16384;
    auto& profile = display.profile;
    auto quilt = display.root.table("quilt");
    auto& layout = profile.quilt;
    layout.columns = quilt.integer("columns", {1, 100});
    layout.rows = quilt.integer("rows", {1, 100});
    layout.tileWidth = quilt.integer("tile_width", {8, kLargestTexture});
    layout.tileHeight = quilt.integer("tile_height", {8, kLargestTexture});
    if (layout.columns * layout.rows < profile.views)
        quilt.reject("rows", "leaves too few tiles for " + std::to_string(profile.views) +
                                 " views (allowed columns x rows >= views)");
    if (layout.columns * layout.tileWidth > kLargestTexture)
        quilt.reject("tile_width", "makes the quilt too wide (allowed columns x tile_width <= " +
                                       std::to_string(kLargestTexture) + ')');
    if (layout.rows * layout.tileHeight > kLargestTexture)
        quilt.reject("tile_height", "makes the quilt too high (allowed rows x tile_height <= " +
                                        std::to_string(kLargestTexture) + ')');
}

void readDepthBudget(DisplayReader& display) {
    auto budget = display.root.table("depth_budget");
    display.profile.disparityFar = budget.number("far", {-0.5, -0.001});
    display.profile.disparityNear = budget.number("near", {0.001, 0.5});
}

/// Which shipped displays a wrong name may mean: those that contain it or are nearly it, else all.
std::string suggestions(const std::string& name) {
    const auto names = displayNames();
    const std::vector<std::string_view> words(names.begin(), names.end());
    std::string list(nearestWord(name, words));
    if (list.empty() && !name.empty())
        for (const std::string& word : names)
            if (word.find(name) != std::string::npos) list += (list.empty() ? "" : ", ") + word;
    return list.empty() ? allowed(words) : "(did you mean " + list + "?)";
}

/// A unit's file may build on a shipped one: what it gives replaces what that says.
void inheritBase(DisplayReader& display) {
    if (!display.root.has("base")) return;
    const std::string base = display.root.text("base");
    const std::string file = std::string(kShippedFolder) + base + std::string(kExtension);
    const auto text = embeddedText(file);
    if (text.empty()) {
        display.root.reject("base", '"' + base + "\" is no shipped display " + suggestions(base));
        display.root.check();
    }
    if (display.root.has("type")) {
        const std::string type = TomlReader(file, text).text("type");
        if (display.root.text("type") != type)
            display.root.reject("base", '"' + base + "\" is of type " + type +
                                            " (allowed displays of the file's own type)");
    }
    display.root.inherit(file, text);
}

calib::DisplayProfile readDisplay(const std::string& file, std::string_view text) {
    DisplayReader display(file, text);
    inheritBase(display);
    display.folder = std::filesystem::path(file).parent_path();
    const Type type = readType(display.root);
    auto& profile = display.profile;
    profile.type = type.name;
    profile.model = display.root.text("model");
    readPanel(display, type);
    readViewing(display, type);
    readQuilt(display);
    profile.law = readLaw(display, type);
    readOptics(display, type);
    readDepthBudget(display);
    profile.notes = display.root.table("notes").texts();
    display.root.finish();
    return profile;
}

/// A vendor's calibration is read as the display file that it would be imported as.
calib::DisplayProfile readCalibration(const std::string& file, std::string_view text) {
    const Vendor vendor = vendorOf(text).value_or(Vendor::LookingGlass);
    return readDisplay(file, importDisplay(vendor, file, text).toml);
}

calib::DisplayProfile shippedDisplay(const std::string& name) {
    const std::string file = std::string(kShippedFolder) + name + std::string(kExtension);
    if (const auto text = embeddedText(file); !text.empty()) return displayFromText(file, text);

    throw ConfigError(
        oneLine("display: \"" + name + "\" is no profile and no file *.toml " + suggestions(name)));
}

} // namespace

calib::DisplayProfile loadDisplay(const std::string& nameOrFile) {
    const std::filesystem::path file(nameOrFile);
    const bool isFile = file.extension() == kExtension ||
                        file.extension() == kCalibrationExtension || file.has_parent_path();
    return isFile ? displayFromText(nameOrFile, readTextFile(file)) : shippedDisplay(nameOrFile);
}

calib::DisplayProfile displayFromText(const std::string& file, std::string_view text) {
    const std::filesystem::path path(file);
    auto profile = path.extension() == kCalibrationExtension ? readCalibration(file, text)
                                                             : readDisplay(file, text);
    profile.name = path.stem().string();
    return profile;
}

std::vector<std::string> displayNames() {
    std::vector<std::string> names;
    for (const std::string& file : embeddedNames(kShippedFolder))
        names.push_back(std::filesystem::path(file).stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace autostereo::config
