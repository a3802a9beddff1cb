#include "devices/replay/image_files.hpp"
#include "devices/replay/npy_file.hpp"
#include "tests/support/edid_bytes.hpp"
#include "tests/support/kinect2_unit.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <span>
#include <string>
#include <string_view>

// Good inputs for each fuzzer to start from: shipped files, real calibrations, small arrays and
// pictures. usage: fuzz_seeds OUTPUT SOURCES DATA

namespace {

using namespace autostereo; // NOLINT(google-build-using-namespace): a program's own
namespace fs = std::filesystem;

fs::path folder(const fs::path& output, const char* fuzzer) {
    fs::create_directories(output / fuzzer);
    return output / fuzzer;
}

void write(const fs::path& file, std::span<const std::byte> bytes) {
    std::ofstream(file, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
}

/// A text as a first-generation display would hand it out, page by page.
std::vector<std::byte> repliesWith(std::span<const std::byte> text) {
    constexpr std::size_t kPage = 64;
    std::vector<std::byte> memory{std::byte{0}, std::byte{0},
                                  static_cast<std::byte>(text.size() >> 8U),
                                  static_cast<std::byte>(text.size())};
    memory.insert(memory.end(), text.begin(), text.end());
    memory.resize((memory.size() + kPage - 1) / kPage * kPage);
    std::vector<std::byte> replies;
    for (std::size_t page = 0; page * kPage < memory.size(); ++page) {
        for (const std::size_t byte : {std::size_t{0}, std::size_t{0}, page >> 8U, page})
            replies.push_back(static_cast<std::byte>(byte));
        const auto from = memory.begin() + static_cast<std::ptrdiff_t>(page * kPage);
        replies.insert(replies.end(), from, from + kPage);
    }
    return replies;
}

void copyTexts(const fs::path& output, const fs::path& sources, const fs::path& data) {
    for (const auto& entry : fs::directory_iterator(sources / "config/displays"))
        fs::copy_file(entry, folder(output, "toml") / entry.path().filename());
    if (!fs::exists(data / "lkg-calibrations")) return;
    for (const auto& entry : fs::directory_iterator(data / "lkg-calibrations")) {
        if (entry.path().extension() != ".json") continue;
        fs::copy_file(entry, folder(output, "looking_glass_json") / entry.path().filename());
        write(folder(output, "hid") / entry.path().filename(),
              repliesWith(devices::readFile(entry, 1U << 16U)));
    }
}

void writeKinect2(const fs::path& output) {
    const auto unit = test::inventedUnit();
    write(folder(output, "kinect2_command") / "completion", test::completion(7));
    write(folder(output, "kinect2_page") / "depth", test::depthCameraPage(unit));
    const auto phases = test::phasePage(unit);
    auto ends = std::vector(phases.begin(), phases.begin() + 32); // as the fuzzer fills them in
    ends.insert(ends.end(), phases.end() - 306, phases.end());
    write(folder(output, "kinect2_page") / "phase", ends);
    const auto color = test::colorPage(unit);
    write(folder(output, "kinect2_page") / "color", std::span(color).first(101));
    write(folder(output, "kinect2_color") / "packet",
          test::colorPacket(std::vector<std::byte>(500), 3, 4));
    std::vector<std::byte> steps; // nine sub-images of one sequence
    for (unsigned i = 0; i < 9; ++i)
        for (const unsigned byte : {3U, 0U, 0U, 0U, 1U, 0U, 0U, 0U, i, 0U, 0U, 0U})
            steps.push_back(static_cast<std::byte>(byte));
    write(folder(output, "kinect2_depth") / "frame", steps);
    std::vector<std::byte> records(1, std::byte{255}); // a serial number, a firmware's, two packets
    for (const unsigned kind : {1U, 2U, 6U, 7U}) {
        for (const unsigned byte : {0U, 0U, 0U, 0U, kind, 0U, 0U, 0U, 4U, 0U, 0U, 0U,
                                    1U, 0U, 0U, 0U, 0U,   0U, 0U, 0U, 0U, 0U, 0U, 0U})
            records.push_back(static_cast<std::byte>(byte));
        records.insert(records.end(), 4, std::byte{'5'});
    }
    write(folder(output, "kinect2_raw") / "records", records);
}

void writeRequests(const fs::path& output) {
    int number = 0;
    for (const std::string_view line : {R"({"command":"status"})", R"({"command":"snapshot"})",
                                        R"({"command":"show","what":"live"})",
                                        R"({"command":"set","name":"scale","value":"0.5"})",
                                        R"({"command":"set","name":"method","value":"direct"})",
                                        R"({"command":"set","name":"brightness","value":1e-3})"})
        write(folder(output, "control_request") / std::to_string(number++),
              std::as_bytes(std::span(line)));
}

void writeBinaries(const fs::path& output) {
    write(folder(output, "edid") / "dell", test::bytesOfHex(test::kDell));
    write(folder(output, "edid") / "lg", test::bytesOfHex(test::kLg));
    constexpr std::array<std::byte, 2 * 3 * 8> kElements{};
    for (const auto& [type, size] : {std::pair{"|u1", 1U}, {"<u2", 2U}, {"<f8", 8U}})
        devices::writeNpy(folder(output, "npy") / (std::string(type + 1) + ".npy"),
                          {type, {2, 1, 3}}, std::span(kElements).first(6 * size));
    using devices::ImageFormat;
    for (const auto format :
         {ImageFormat::Grey8, ImageFormat::Rgb8, ImageFormat::Rgba8, ImageFormat::Grey16}) {
        const devices::ImageHeader header{format, 3, 4};
        std::vector<std::byte> pixels(header.bytes());
        std::ranges::generate(pixels, [value = 0U]() mutable { return std::byte(value += 37); });
        devices::writePng(folder(output, "png") / std::to_string(static_cast<int>(format)),
                          {header, pixels});
    }
    for (const char* fuzzer : {"looking_glass_json", "hid"})
        static_cast<void>(folder(output, fuzzer));
    writeKinect2(output);
    std::vector<std::byte> pose(48); // x = 1 cm
    pose[6] = std::byte{0xf0};
    pose[7] = std::byte{0x3f};
    write(folder(output, "opentrack") / "pose", pose);
    constexpr std::string_view kTrace = "# s, m\n0,-0.03,0,0.65,0.03,0,0.65\n1.5,0,0,1,.06,0,1\n";
    write(folder(output, "eye_trace") / "trace", std::as_bytes(std::span(kTrace)));
}

} // namespace

int main(int argc, char** argv) try {
    if (argc != 4) throw std::runtime_error("usage: fuzz_seeds OUTPUT SOURCES DATA");
    copyTexts(argv[1], argv[2], argv[3]);
    writeRequests(argv[1]);
    writeBinaries(argv[1]);
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}
