#pragma once

#include "calib/camera_model.hpp"
#include "calib/eye_pair.hpp"
#include "calib/sensor_rig.hpp"
#include "devices/frame.hpp"
#include "devices/tracking/params.hpp"
#include "devices/tracking/pupil.hpp"

#include <optional>

namespace autostereo::devices {

/// Eyes in the camera's frame, metres, of a viewer who looks at the camera: both are as far from
/// it, so distance = spacing / |difference of the two directions|. Turned away by an angle a they
/// are given as 1 / cos(a) times as far: 3.5 % at 15 degrees. Nothing: outside of what the camera's
/// model covers. Reentrant.
[[nodiscard]] std::optional<calib::EyePair> eyesBySpacing(const calib::CameraModel& camera,
                                                          const PupilPair& pupils, double spacingM);

/// The same eyes moved along the camera's rays until the middle between them is `depthM` along its
/// axis.
[[nodiscard]] calib::EyePair movedTo(const calib::EyePair& eyes, double depthM);

/// The face's depth along the colour camera's axis as the depth camera measures it: the median in
/// the band about `eyes` (colour camera's frame), which only has to be about right. Nothing: hardly
/// any measurements there, or none within a third of where `eyes` are.
[[nodiscard]] std::optional<double> measuredDepth(const Frame& depth, const calib::SensorRig& rig,
                                                  const calib::EyePair& eyes);

/// From a camera's frame to display space: the camera stands at pose.originM (none: the panel's
/// centre) and with pose.rotationRad = 0 looks straight out of the panel, upright; face to face
/// with the viewer its right is their left.
[[nodiscard]] calib::EyePair inDisplaySpace(const calib::EyePair& eyes, const TrackerPose& pose);

} // namespace autostereo::devices
