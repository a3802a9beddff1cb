#include "calib/phase_tables.hpp"
#include "config/display_reader.hpp"
#include "config/load.hpp"
#include "config/phrases.hpp"
#include "devices/replay/image_files.hpp"
#include "devices/replay/npy_file.hpp"

#include <cmath>
#include <cstring>

namespace autostereo::config {

namespace {

constexpr std::size_t kLargestFile = std::size_t{2} << 30;

/// What one element of the file means.
struct Meaning {
    bool phases = false;
    int views = 1;
};

[[noreturn]] void reject(const std::filesystem::path& file, const std::string& why) {
    throw std::runtime_error(file.string() + ": " + why);
}

std::uint32_t phaseOf(const std::filesystem::path& file, const Meaning& meaning, double number,
                      std::size_t at) {
    if (meaning.phases && std::isfinite(number)) return calib::turns(number);
    if (!meaning.phases && number >= 0 && number < meaning.views && number == std::floor(number))
        return calib::turns((number + 0.5L) / meaning.views);
    reject(file, "element " + std::to_string(at) + " is " + plain(number) + ' ' +
                     (meaning.phases ? "(allowed finite phases)"
                                     : allowed(Range{0, meaning.views - 1.0})));
}

template<class Element>
std::vector<std::uint32_t> converted(const std::filesystem::path& file, const Meaning& meaning,
                                     std::span<const std::byte> data) {
    std::vector<std::uint32_t> phases(data.size() / sizeof(Element));
    for (std::size_t i = 0; i < phases.size(); ++i) {
        Element element;
        std::memcpy(&element, data.data() + i * sizeof(Element), sizeof(Element));
        phases[i] = phaseOf(file, meaning, static_cast<double>(element), i);
    }
    return phases;
}

std::string shapeText(const std::vector<std::size_t>& shape) {
    std::string text;
    for (const std::size_t extent : shape)
        text += (text.empty() ? "" : " x ") + std::to_string(extent);
    return text;
}

std::vector<std::uint32_t> fromNpy(const std::filesystem::path& file, const Meaning& meaning,
                                   int width, int height) {
    const devices::NpyArray array = devices::readNpy(file, kLargestFile);
    const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
    if (array.header.shape != std::vector<std::size_t>{h, w, 3})
        reject(file, "is " + shapeText(array.header.shape) + " (allowed " + shapeText({h, w, 3}) +
                         ", as the panel)");
    const std::string& type = array.header.type;
    if (meaning.phases && type == "<u4") { // the format of `autostereo viewmap`
        std::vector<std::uint32_t> phases(array.header.elements());
        std::memcpy(phases.data(), array.data.data(), array.data.size());
        return phases;
    }
    if (meaning.phases != (type[1] == 'f'))
        reject(file, "holds " + type +
                         (meaning.phases ? " (allowed <u4, <f4, <f8 for phases)"
                                         : " (allowed |u1, <u2, <u4 for views)"));
    if (type == "|u1") return converted<std::uint8_t>(file, meaning, array.data);
    if (type == "<u2") return converted<std::uint16_t>(file, meaning, array.data);
    if (type == "<u4") return converted<std::uint32_t>(file, meaning, array.data);
    if (type == "<f4") return converted<float>(file, meaning, array.data);
    return converted<double>(file, meaning, array.data);
}

/// Each channel's level is the view of that sub-pixel.
std::vector<std::uint32_t> fromPicture(const std::filesystem::path& file, const Meaning& meaning,
                                       int width, int height) {
    if (file.extension() != ".png") reject(file, "is no .npy and no .png");
    devices::ImageReader reader;
    const devices::ImageHeader header = reader.open(file);
    if (meaning.phases) reject(file, "a picture holds no phases (allowed .npy)");
    if (header.width != width || header.height != height ||
        header.format != devices::ImageFormat::Rgba8)
        reject(file, "is " + header.size().text() +
                         (header.format == devices::ImageFormat::Grey16 ? ", 16-bit" : "") +
                         " (allowed an 8-bit picture of " +
                         devices::PictureSize{width, height}.text() + ')');
    std::vector<std::byte> pixels(header.bytes());
    reader.decode(pixels);
    std::vector<std::uint32_t> phases;
    phases.reserve(pixels.size() / 4 * 3);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (i % 4 != 3)
            phases.push_back(
                phaseOf(file, meaning, std::to_integer<int>(pixels[i]), i / 4 * 3 + i % 4));
    return phases;
}

} // namespace

calib::ViewLut readLut(DisplayReader& display) {
    const auto& profile = display.profile;
    auto lens = display.root.table("lens");
    display.noteLensOrigin("file");
    const std::string name = lens.text("file");
    const Meaning meaning{lens.choice<bool>("holds", {{"views", false}, {"phases", true}}),
                          profile.remap.empty() ? profile.views
                                                : static_cast<int>(profile.remap.size())};
    if (name.empty()) lens.reject("file", "is empty (allowed *.npy, *.png)");
    display.root.check(); // before a file is read on the word of wrong numbers
    const std::filesystem::path file = display.folder / name;
    try {
        auto phases = file.extension() == ".npy"
                          ? fromNpy(file, meaning, profile.width, profile.height)
                          : fromPicture(file, meaning, profile.width, profile.height);
        return {profile.width, profile.height,
                std::make_shared<const std::vector<std::uint32_t>>(std::move(phases))};
    } catch (const std::runtime_error& error) {
        lens.reject("file", error.what());
        display.root.check();
        throw;
    }
}

} // namespace autostereo::config
