#include "config/read_framing.hpp"

#include "config/read_picture.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace autostereo::config {

namespace {

void readChoice(TomlReader& framing, calib::FramingChoice& choice) {
    const int turned = framing.integer("mounting_deg", {0, 270}, 90 * choice.quarterTurns);
    if (turned % 90 != 0)
        framing.reject("mounting_deg",
                       std::to_string(turned) + " is no quarter turn (allowed 0, 90, 180, 270)");
    choice.quarterTurns = turned / 90;
    choice.mirror = framing.boolean("mirror", choice.mirror);
    choice.zoom = framing.number("zoom", {1, 20}, choice.zoom);
    const auto pan = framing.numbers<2>("pan", {-1, 1}, std::array{choice.pan.x, choice.pan.y});
    choice.pan = {pan[0], pan[1]};
}

std::uint8_t level(double share) { return static_cast<std::uint8_t>(std::lround(255 * share)); }

void readBackdrop(TomlReader& framing, const std::filesystem::path& folder,
                  gpu::BackdropParams& backdrop) {
    backdrop.cutM = framing.number("far_cut_m", {0, 100}, backdrop.cutM);
    const auto color = framing.numbers<3>("backdrop_color", {0, 1}, std::array{0.0, 0.0, 0.0});
    const std::string name = framing.text("backdrop_picture", "");
    if (!name.empty()) {
        try {
            calib::Picture picture = readPicture(folder / name);
            backdrop.width = picture.width;
            backdrop.height = picture.height;
            backdrop.pixels = std::move(picture.pixels);
        } catch (const std::runtime_error& error) {
            framing.reject("backdrop_picture", error.what());
        }
    } else if (framing.has("backdrop_color")) {
        backdrop.width = backdrop.height = 1;
        backdrop.pixels = {level(color[0]), level(color[1]), level(color[2]), 255};
    }
}

} // namespace

void readFraming(TomlReader& framing, const std::filesystem::path& folder,
                 gpu::PipelineParams& params) {
    readChoice(framing, params.framing);
    readBackdrop(framing, folder, params.backdrop);
}

} // namespace autostereo::config
