#include "config/display_reader.hpp"
#include "config/phrases.hpp"
#include "config/units.hpp"

namespace autostereo::config {

namespace {

/// Rise start, rise end, fall start, fall end within a cycle.
std::array<double, 4> readEdges(TomlReader& table, std::string_view channel) {
    const auto edges = table.numbers<4>(channel, {0, 1});
    if (!std::is_sorted(edges.begin(), edges.end()))
        table.reject(channel, "is not in order (allowed rise start <= rise end <= fall start <= "
                              "fall end)");
    return edges;
}

std::vector<calib::Waveform> readWaveform(TomlReader& root) {
    if (!root.has("waveform")) return {};
    auto table = root.table("waveform");
    calib::Waveform waveform;
    waveform.edges = {readEdges(table, "red"), readEdges(table, "green"), readEdges(table, "blue")};
    waveform.negativeLobe = table.number("negative_lobe", {0, 1}, 0);
    return {waveform};
}

std::vector<glm::dvec3> readEyes(DisplayReader& display, TomlReader& barrier, double thicknessM) {
    std::vector<glm::dvec3> eyes;
    if (!barrier.has("eyes_m")) return eyes;
    const double views = display.profile.views;
    for (const auto& row : barrier.numberRows("eyes_m", {views, views}, {3, 3}, {-100, 100})) {
        eyes.emplace_back(row[0], row[1], row[2]);
        if (!(row[2] > thicknessM))
            barrier.reject("eyes_m", "has an eye at z = " + plain(row[2]) +
                                         " (allowed in front of the barrier)");
    }
    return eyes;
}

} // namespace

calib::LineScreen readLineScreen(DisplayReader& display) {
    using Form = calib::LineScreen::Form;
    auto barrier = display.root.table("barrier");
    calib::LineScreen screen;
    screen.linesPerM = display.lensNumber(barrier, "lines_per_m", {1, 100'000});
    screen.dutyCycle = display.lensNumber(barrier, "duty_cycle", {0.01, 0.99});
    screen.thicknessM =
        units::metresFromMm(display.lensNumber(barrier, "thickness_mm", {0.001, 1000}));
    screen.angleRad = units::radiansFromDeg(display.lensNumber(barrier, "angle_deg", {-60, 60}));
    screen.shiftM = units::metresFromMm(display.lensNumber(barrier, "shift_mm", {-1000, 1000}));
    screen.guard = barrier.number("guard", {-0.98, 0.98}, 0);
    if (!(screen.guard < 1 - screen.dutyCycle))
        barrier.reject("guard", "leaves no light (allowed < 1 - duty_cycle)");
    if (!(screen.guard > -screen.dutyCycle))
        barrier.reject("guard", "leaves nothing dark (allowed > -duty_cycle)");
    if (!(display.profile.viewingDistanceM > screen.thicknessM))
        barrier.reject("thickness_mm", "reaches the viewer (allowed < viewing.distance_m)");
    screen.form =
        barrier.choice<Form>("form", {{"exact", Form::Exact}, {"paper", Form::Paper}}, Form::Exact);
    const double third = 1e3 * display.profile.widthM / (3 * display.profile.width);
    const auto offsets =
        barrier.numbers<3>("subpixel_offsets_mm", {-10, 10}, std::array{-third, 0.0, third});
    for (std::size_t c = 0; c < 3; ++c)
        screen.subpixelOffsetsM[c] = units::metresFromMm(offsets[c]);
    screen.eyes = readEyes(display, barrier, screen.thicknessM);
    screen.waveform = readWaveform(display.root);
    screen.grid = readPhaseGrid(display);
    return screen;
}

} // namespace autostereo::config
