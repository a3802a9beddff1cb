#include "tests/replay/x_server.hpp"

#include <xcb/xfixes.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <thread>

namespace autostereo::test {

namespace {

constexpr const char* kServer = "/usr/bin/Xvfb";
constexpr const char* kScreenshot = "/usr/bin/xwd";
constexpr const char* kSettings = "/usr/bin/xset";
constexpr const char* kKeys = "/usr/bin/xdotool";

ProgramCall serverCall(int width, int height) {
    ProgramCall call;
    call.program = kServer;
    // Without -noreset it starts afresh when its last client leaves, and refuses the next
    // meanwhile.
    call.arguments = {"-noreset",  "-displayfd",
                      "1",         "-screen",
                      "0",         std::to_string(width) + "x" + std::to_string(height) + "x24",
                      "-nolisten", "tcp"};
    return call;
}

/// The file that xwd writes: a header of big-endian words, its window's name, colour cells of 12
/// bytes, rows. Only what our server has is read: four bytes a pixel, blue first.
ColorPicture parseXwd(const std::string& bytes) {
    enum Field {
        HeaderSize,
        Width = 4,
        Height = 5,
        ByteOrder = 7,
        BitsPerPixel = 11,
        BytesPerLine = 12,
        Red = 14,
        Blue = 16,
        Colors = 19,
        Fields = 25
    };
    std::array<std::size_t, Fields> header{};
    if (bytes.size() < 4 * header.size()) throw std::runtime_error("xwd: no header");
    const auto byteAt = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes[i]); };
    for (std::size_t i = 0; i < header.size(); ++i)
        for (std::size_t j = 0; j < 4; ++j)
            header[i] = header[i] << 8U | byteAt(4 * i + j);
    const std::size_t first = header[HeaderSize] + 12 * header[Colors];
    if (header[ByteOrder] != 0 || header[BitsPerPixel] != 32 || header[Red] != 0xff0000 ||
        header[Blue] != 0xff || header[BytesPerLine] < 4 * header[Width] ||
        bytes.size() < first + header[Height] * header[BytesPerLine])
        throw std::runtime_error("xwd: not a screen of 24 bits");
    ColorPicture picture{static_cast<int>(header[Width]), static_cast<int>(header[Height]), {}};
    for (std::size_t y = 0; y < header[Height]; ++y)
        for (std::size_t x = 0; x < header[Width]; ++x) {
            const std::size_t pixel = first + y * header[BytesPerLine] + 4 * x;
            picture.rgb.insert(picture.rgb.end(),
                               {byteAt(pixel + 2), byteAt(pixel + 1), byteAt(pixel)});
        }
    return picture;
}

} // namespace

XServer::XServer(int width, int height) : server_(serverCall(width, height)) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (!number_.ends_with('\n')) {
        if (!server_.running() || std::chrono::steady_clock::now() > deadline)
            throw std::runtime_error("Xvfb does not start");
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        number_ = server_.out();
    }
    number_.pop_back();
}

ColorPicture XServer::screenshot() const {
    ProgramCall call;
    call.program = kScreenshot;
    call.arguments = {"-root", "-silent", "-display", display()};
    const ProgramResult result = runProgram(call);
    if (result.exitCode != 0) throw std::runtime_error(result.err);
    return parseXwd(result.out);
}

void XServer::press(const std::vector<std::string>& keys) const {
    ProgramCall call;
    call.program = kKeys;
    call.arguments = {"key", "--delay", "50"};
    call.arguments.insert(call.arguments.end(), keys.begin(), keys.end());
    call.environment = {"DISPLAY=" + display()};
    const ProgramResult result = runProgram(call);
    if (result.exitCode != 0) throw std::runtime_error("xdotool: " + result.err);
}

int XServer::screenSaverTimeout() const {
    ProgramCall call;
    call.program = kSettings;
    call.arguments = {"-display", display(), "q"};
    const ProgramResult result = runProgram(call);
    constexpr std::string_view kLine = "timeout:";
    const auto at = result.out.find(kLine);
    if (result.exitCode != 0 || at == std::string::npos) throw std::runtime_error(result.err);
    return std::stoi(result.out.substr(at + kLine.size()));
}

bool XServer::pointerVisible() const {
    struct Freer {
        void operator()(void* reply) const { std::free(reply); }
        void operator()(xcb_connection_t* connection) const { xcb_disconnect(connection); }
    };
    const std::unique_ptr<xcb_connection_t, Freer> x(xcb_connect(display().c_str(), nullptr));
    const std::unique_ptr<xcb_xfixes_query_version_reply_t, Freer> version(
        xcb_xfixes_query_version_reply(x.get(), xcb_xfixes_query_version(x.get(), 4, 0), nullptr));
    const std::unique_ptr<xcb_xfixes_get_cursor_image_reply_t, Freer> image(
        xcb_xfixes_get_cursor_image_reply(x.get(), xcb_xfixes_get_cursor_image(x.get()), nullptr));
    if (!version || !image) throw std::runtime_error("X does not tell its pointer's picture");
    const std::span pixels(
        xcb_xfixes_get_cursor_image_cursor_image(image.get()),
        static_cast<std::size_t>(xcb_xfixes_get_cursor_image_cursor_image_length(image.get())));
    return std::ranges::any_of(pixels, [](std::uint32_t argb) { return argb >> 24U != 0; });
}

std::optional<std::string> XServer::missing() {
    for (const char* program : {kServer, kScreenshot, kSettings, kKeys})
        if (!std::filesystem::exists(program)) return std::string(program) + " is not installed";
    return std::nullopt;
}

} // namespace autostereo::test
