#include "daemon/commands/commands.hpp"
#include "daemon/control/control_client.hpp"
#include "daemon/control/control_socket.hpp"
#include "daemon/picture_files.hpp"
#include "daemon/session/status.hpp"
#include "devices/replay/whole_file.hpp"

#include <nlohmann/json.hpp>

#include <iostream>
#include <span>

namespace autostereo::daemon {

namespace {

devices::UniqueFd connection(const ControlOptions& options) {
    if (options.socket) return connectTo(*options.socket);
    std::string tried;
    for (const auto& place : knownControlSockets()) {
        try {
            return connectTo(place);
        } catch (const ControlError& error) {
            if (!error.nobodyThere()) throw;
            tried += (tried.empty() ? "" : ", ") + place.string();
        }
    }
    throw ControlError("control: no program answers at " + tried +
                           " (is autostereo run running? else give --socket)",
                       true);
}

void writeSnapshot(const std::filesystem::path& file, const nlohmann::json& line,
                   ControlAnswer answer) {
    gpu::RgbImage image{line.at("width").get<int>(), line.at("height").get<int>(),
                        std::move(answer.bytes)};
    const auto pixels = static_cast<std::size_t>(std::max(0, image.width)) *
                        static_cast<std::size_t>(std::max(0, image.height));
    if (image.pixels.empty() || image.pixels.size() != 3 * pixels)
        throw std::runtime_error("control: a picture of the wrong size");
    writePicturePng(file, image);
}

void writeRecording(const std::filesystem::path& file, const ControlAnswer& answer) {
    const auto bytes = std::as_bytes(std::span(answer.bytes));
    devices::writeWhole(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()},
                        "snapshot: ");
}

} // namespace

int control(const ControlOptions& options) try {
    const devices::UniqueFd socket = connection(options);
    ControlAnswer answer = ask(socket.get(), options.request);
    const auto line = nlohmann::json::parse(answer.line);
    if (!line.value("ok", false)) {
        std::cerr << "autostereo: " << line.value("error", "refused without a reason") << '\n';
        return line.value("code", EXIT_FAILURE);
    }
    if (std::holds_alternative<SnapshotRequest>(options.request))
        writeSnapshot(options.output, line, std::move(answer));
    else if (std::holds_alternative<RecordingRequest>(options.request))
        writeRecording(options.output, answer);
    else if (std::holds_alternative<StatusRequest>(options.request))
        std::cout << (options.json ? answer.line + '\n' : statusText(answer.line));
    return EXIT_SUCCESS;
} catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(std::string("control: an answer that cannot be read: ") +
                             error.what());
}

} // namespace autostereo::daemon
