#pragma once

#include "devices/tracking/pupil.hpp"

#include <filesystem>
#include <memory>
#include <optional>

namespace autostereo::devices {

/// Faces that look at a camera, and their pupils: cascades of Haar features (Viola and Jones 2001)
/// for the face and for either eye, then pupilCentre. A face is searched near the last one, and in
/// the whole picture when it is not there, and in any case every 30 pictures, when one that is half
/// as wide again takes over; else of several it takes the nearest to the last, at first the
/// largest. Only a face with both eyes counts. A face that leans is searched in a picture turned
/// with it, one that is not found yet in pictures turned by 16 degrees either way, too. Measured
/// limits: README.md. Thread-bound; works on the calling thread alone.
class FaceFinder {
  public:
    static constexpr const char* kCascades = "/usr/share/opencv4/haarcascades";

    /// Throws DeviceError where `cascades` has not what it takes.
    explicit FaceFinder(const std::filesystem::path& cascades = kCascades);
    ~FaceFinder();
    FaceFinder(const FaceFinder&) = delete;
    FaceFinder& operator=(const FaceFinder&) = delete;

    [[nodiscard]] std::optional<PupilPair> find(const GreyView& picture);

  private:
    class Cascades;
    std::unique_ptr<Cascades> cascades_;
};

} // namespace autostereo::devices
