#include "calib/phase_laws.hpp"
#include "config/load.hpp"
#include "config/phrases.hpp"
#include "config/text_file.hpp"
#include "config/toml_reader.hpp"
#include "config/units.hpp"

#include <algorithm>
#include <string>

namespace autostereo::config {

namespace {

constexpr std::string_view kShippedFolder = "displays/";
constexpr std::string_view kExtension = ".toml";

/// One display file -> DisplayProfile. Every number that describes the glass must be there and
/// have its origin under [provenance]; what the picture is made of (views, quilt, budget) is a
/// choice and needs none.
class DisplayReader {
  public:
    DisplayReader(const std::string& file, std::string_view text)
        : root_(file, text), provenance_(root_.table("provenance")) {}

    calib::DisplayProfile read();

  private:
    enum class Type { Linear, VanBerkel, LookingGlass, Preview };

    std::string origin(std::string_view key);
    double physical(TomlReader& table, std::string_view key, Range range);
    double lensNumber(std::string_view key, Range range);
    void noteLensOrigin(std::string_view key);

    void readPanel(Type type);
    void readViewing();
    void readMultiview(Type type);
    void readPreviewMode();
    void readQuilt();
    void readDepthBudget();
    calib::LinearPhase lookingGlass();
    calib::LinearPhase vanBerkel();
    calib::LinearPhase linear();

    TomlReader root_;
    TomlReader provenance_;
    TomlReader lens_ = root_.table("lens");
    calib::DisplayProfile profile_;
};

std::string DisplayReader::origin(std::string_view key) {
    auto word = provenance_.choice<std::string>(key, {{"per-unit", "per-unit"},
                                                      {"template", "template"},
                                                      {"measured", "measured"},
                                                      {"assumed", "assumed"}});
    profile_.provenance.emplace(key, word);
    return word;
}

double DisplayReader::physical(TomlReader& table, std::string_view key, Range range) {
    origin(key);
    return table.number(key, range);
}

/// The lens sits differently on every unit: a phase from anywhere but this one is a placeholder.
void DisplayReader::noteLensOrigin(std::string_view key) {
    const std::string from = origin(key);
    if (from == "template" || from == "assumed") profile_.placeholder = true;
}

double DisplayReader::lensNumber(std::string_view key, Range range) {
    noteLensOrigin(key);
    return lens_.number(key, range);
}

void DisplayReader::readPanel(Type type) {
    auto panel = root_.table("panel");
    const Range pixels{type == Type::Preview ? 0.0 : 16.0, 16384}; // preview: 0 = any mode
    profile_.width = panel.integer("width", pixels);
    profile_.height = panel.integer("height", pixels);
    if ((profile_.width == 0) != (profile_.height == 0))
        panel.reject("height", "must be 0 where width is, and only there");
    if (type != Type::LookingGlass) // whose dpi says it
        profile_.widthM = units::metresFromMm(physical(panel, "width_mm", {10, 20000}));
}

void DisplayReader::readViewing() {
    auto viewing = root_.table("viewing");
    profile_.viewingDistanceM = physical(viewing, "distance_m", {0.05, 100});
    profile_.coneRad = units::radiansFromDeg(physical(viewing, "cone_deg", {1, 120}));
}

void DisplayReader::readMultiview(Type type) {
    auto viewing = root_.table("viewing");
    profile_.views = viewing.integer("views", {1, 1000});
    profile_.order = viewing.choice<calib::ViewOrder>(
        "view_order", {{"left_to_right", calib::ViewOrder::LeftToRight},
                       {"right_to_left", calib::ViewOrder::RightToLeft}});
    profile_.fan = viewing.choice<calib::Fan>(
        "fan", {{"centres", calib::Fan::Centres}, {"edges", calib::Fan::Edges}});
    if (profile_.fan == calib::Fan::Edges && profile_.views < 2)
        viewing.reject("fan", "\"edges\" needs two views or more (allowed centres)");
    profile_.phase = type == Type::LookingGlass ? lookingGlass()
                     : type == Type::VanBerkel  ? vanBerkel()
                                                : linear();
}

/// No lens. Anaglyph: the red channel is the left view, green and blue are the right one; the two
/// eyes are the ends of the fan.
void DisplayReader::readPreviewMode() {
    const bool anaglyph = root_.choice<bool>("mode", {{"anaglyph", true}, {"2d", false}});
    profile_.views = anaglyph ? 2 : 1;
    profile_.fan = anaglyph ? calib::Fan::Edges : calib::Fan::Centres;
    if (anaglyph)
        profile_.phase.channel = {0.25, 0.75, 0.75};
    else
        profile_.phase.channel = {0.5, 0.5, 0.5};
}

calib::LinearPhase DisplayReader::lookingGlass() {
    calib::LookingGlassCalibration unit;
    unit.pitch = lensNumber("pitch", {1, 1000});
    unit.slope = lensNumber("slope", {-1000, 1000});
    if (std::abs(unit.slope) < 1)
        lens_.reject("slope",
                     plain(unit.slope) + " is out of range (allowed -1000 to -1 and 1 to 1000)");
    unit.center = lensNumber("center", {-100, 100});
    unit.dpi = lensNumber("dpi", {10, 2000});
    unit.screenWidth = profile_.width;
    unit.screenHeight = profile_.height;
    unit.flipImageX = lens_.boolean("flip_image_x");
    noteLensOrigin("flip_image_x");
    profile_.widthM = units::metresFromInches(unit.screenWidth / unit.dpi);
    return calib::lookingGlassPhase(unit);
}

calib::LinearPhase DisplayReader::vanBerkel() {
    calib::VanBerkelLens sheet;
    sheet.subpixelsPerLens = lensNumber("subpixels_per_lens", {1, 1000});
    sheet.rowShiftSubpixels = lensNumber("row_shift_subpixels", {-100, 100});
    sheet.offsetSubpixels = lensNumber("offset_subpixels", {-1000, 1000});
    return calib::vanBerkelPhase(sheet, profile_.views);
}

calib::LinearPhase DisplayReader::linear() {
    constexpr Range kCycles{-100, 100};
    calib::LinearPhase phase;
    phase.perColumn = lensNumber("per_column", kCycles);
    phase.perRow = lensNumber("per_row", kCycles);
    noteLensOrigin("channel");
    phase.channel = lens_.numbers<3>("channel", kCycles);
    phase.offset = lensNumber("offset", kCycles);
    return phase;
}

void DisplayReader::readQuilt() {
    constexpr int kLargestTexture = 16384;
    auto quilt = root_.table("quilt");
    auto& layout = profile_.quilt;
    layout.columns = quilt.integer("columns", {1, 100});
    layout.rows = quilt.integer("rows", {1, 100});
    layout.tileWidth = quilt.integer("tile_width", {8, kLargestTexture});
    layout.tileHeight = quilt.integer("tile_height", {8, kLargestTexture});
    if (layout.columns * layout.rows < profile_.views)
        quilt.reject("rows", "leaves too few tiles for " + std::to_string(profile_.views) +
                                 " views (allowed columns x rows >= views)");
    if (layout.columns * layout.tileWidth > kLargestTexture)
        quilt.reject("tile_width", "makes the quilt too wide (allowed columns x tile_width <= " +
                                       std::to_string(kLargestTexture) + ')');
    if (layout.rows * layout.tileHeight > kLargestTexture)
        quilt.reject("tile_height", "makes the quilt too high (allowed rows x tile_height <= " +
                                        std::to_string(kLargestTexture) + ')');
}

void DisplayReader::readDepthBudget() {
    auto budget = root_.table("depth_budget");
    profile_.disparityFar = budget.number("far", {-0.5, -0.001});
    profile_.disparityNear = budget.number("near", {0.001, 0.5});
}

calib::DisplayProfile DisplayReader::read() {
    const auto type = root_.choice<Type>("type", {{"linear", Type::Linear},
                                                  {"van_berkel", Type::VanBerkel},
                                                  {"looking_glass", Type::LookingGlass},
                                                  {"preview", Type::Preview}});
    root_.check(); // which keys are known depends on it
    profile_.type = root_.text("type");
    profile_.model = root_.text("model");
    readPanel(type);
    readViewing();
    if (type == Type::Preview)
        readPreviewMode();
    else
        readMultiview(type);
    readQuilt();
    readDepthBudget();
    root_.finish();
    return profile_;
}

calib::DisplayProfile shippedDisplay(const std::string& name) {
    const std::string file = std::string(kShippedFolder) + name + std::string(kExtension);
    if (const auto text = embeddedText(file); !text.empty())
        return DisplayReader(file, text).read();

    const auto names = displayNames();
    const std::vector<std::string_view> words(names.begin(), names.end());
    throw ConfigError(
        oneLine("display: \"" + name + "\" is no profile and no file *.toml " + allowed(words)));
}

} // namespace

calib::DisplayProfile loadDisplay(const std::string& nameOrFile) {
    const std::filesystem::path file(nameOrFile);
    const bool isFile = file.extension() == kExtension || file.has_parent_path();
    auto profile =
        isFile ? DisplayReader(nameOrFile, readTextFile(file)).read() : shippedDisplay(nameOrFile);
    profile.name = isFile ? file.stem().string() : nameOrFile;
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
