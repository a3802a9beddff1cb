#include "devices/record/recorded_picture.hpp"

#include "devices/record/payloads.hpp"
#include "devices/replay/calibration_files.hpp"
#include "devices/replay/kinect_recording.hpp"

#include <span>
#include <string>

namespace autostereo::devices {

namespace {

std::vector<std::byte> bytesOf(const std::string& text) {
    const auto bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

} // namespace

RecordedPicture copyOf(RecordedStream stream, const Frame& frame) {
    const auto sent = sentBytes(frame), infrared = std::as_bytes(frame.amplitude());
    return {
        stream, frame.metadata(), {sent.begin(), sent.end()}, {infrared.begin(), infrared.end()}};
}

RecordingHead headOf(const Input& input) {
    RecordingHead head;
    if (!input.factoryCalibration.empty())
        head.attachments.push_back(
            {"calibration.json", "K4A_CALIBRATION_FILE", input.factoryCalibration});
    if (input.rig)
        head.attachments.push_back(
            {"camera.json", kCameraFileTag, bytesOf(cameraFile(*input.rig))});
    head.period = input.nominalPeriod;
    head.streams = (input.depth ? 1U : 0U) + (input.color ? 1U : 0U);
    return head;
}

} // namespace autostereo::devices
