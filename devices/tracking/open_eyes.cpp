#include "devices/tracking/open_eyes.hpp"

#include "devices/input.hpp"
#include "devices/tracking/camera_source.hpp"
#include "devices/tracking/opentrack_source.hpp"
#include "devices/tracking/own_camera_source.hpp"
#include "devices/tracking/trace_source.hpp"
#include "devices/uri.hpp"

#include <spdlog/spdlog.h>

#include <charconv>
#include <string_view>
#include <utility>

namespace autostereo::devices {

namespace {

constexpr const char* kLoopback = "127.0.0.1";
constexpr std::string_view kCamera = "camera:";

std::unique_ptr<EyeSource> openOpentrack(const Uri& uri, const ViewerParams& params,
                                         const glm::dvec3& nominal, Clock& clock) {
    const std::size_t colon = uri.path.rfind(':');
    const bool named = colon != std::string::npos;
    const std::string digits = uri.path.substr(named ? colon + 1 : 0);
    std::uint16_t port = 0;
    const char* end = digits.data() + digits.size();
    const auto [rest, error] = std::from_chars(digits.data(), end, port);
    if (error != std::errc{} || rest != end || port == 0)
        throw AddressError(uri.text + ": port '" + digits +
                           "' (allowed opentrack:[ADDRESS:]PORT, 1 to 65535)");
    return std::make_unique<OpentrackSource>(named ? uri.path.substr(0, colon) : kLoopback, port,
                                             params, nominal, clock);
}

std::unique_ptr<EyeSource> openCamera(const ViewerParams& params, Clock& clock) {
    Input input = openInput(params.source.substr(kCamera.size()));
    const bool assumed = !input.rig || input.rig->provenance == "nominal";
    if (assumed && !params.camera && params.fieldOfViewRad == 0)
        spdlog::warn(
            "viewer: {}: what the camera sees from left to right is assumed, and distances "
            "are as wrong as that is (give viewer.camera_rig or viewer.camera_fov_deg)",
            params.source);
    spdlog::info("viewer: {}", input.description);
    return std::make_unique<CameraSource>(params, std::move(input), clock);
}

} // namespace

std::unique_ptr<EyeSource> openEyes(const ViewerParams& params, const glm::dvec3& nominal,
                                    TimePoint start, bool hurried, Clock& clock) {
    if (params.source == kCamera) return std::make_unique<OwnCameraSource>(params, hurried);
    if (params.source.starts_with(kCamera)) return openCamera(params, clock);
    const Uri uri = parseUri(params.source);
    uri.allowOnly({});
    if (uri.scheme == "opentrack") return openOpentrack(uri, params, nominal, clock);
    if (uri.scheme == "file") return std::make_unique<TraceSource>(readEyeTrace(uri.path), start);
    throw AddressError("viewer: " + params.source +
                       ": no tracker (allowed camera:[URI], file:TRACE, "
                       "opentrack:[ADDRESS:]PORT)");
}

} // namespace autostereo::devices
