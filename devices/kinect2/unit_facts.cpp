#include "devices/kinect2/unit_facts.hpp"

#include "devices/kinect2/mirror.hpp"
#include "devices/kinect2/registration.hpp"

#include <chrono>
#include <cstdio>
#include <utility>

namespace autostereo::devices::kinect2 {

namespace {

std::string inWords(const UnitFacts& facts, const FittedRig& fitted) {
    char pixels[64];
    std::string text = "Kinect v2 " + facts.serial + ", firmware " + facts.firmware +
                       ", 512x424 depth and 1920x1080 colour at 30 fps";
    const RegistrationCheck check = checkRegistration(facts.color, facts.depth);
    if (check.points > 0) {
        std::snprintf(pixels, sizeof pixels, "; %d points of its factory met to %.2f px",
                      check.points, check.rmsPx);
        text += pixels;
    }
    std::snprintf(pixels, sizeof pixels, "; its rig fits to %.2f px", fitted.rmsPx);
    return text + pixels;
}

} // namespace

UnitFacts parseFacts(UnitPages pages) {
    UnitFacts facts;
    facts.serial = pages.serial;
    facts.firmware = pages.firmware;
    facts.depth = parseDepthCameraPage(pages.depth);
    facts.phases = parsePhasePage(pages.phases);
    facts.color = parseColorPage(pages.color);
    facts.pages = std::move(pages);
    return facts;
}

void describe(Input& input, const UnitFacts& facts, const std::optional<calib::SensorRig>& rig) {
    const FittedRig fitted = fitRig(facts.color, facts.depth);
    input.description = inWords(facts, fitted);
    if (!facts.phases.note.empty())
        input.warnings.push_back("kinect2 " + facts.serial + ": " + facts.phases.note);
    input.rig = rig ? *rig : mirrored(fitted.rig);
    input.nominalPeriod = std::chrono::nanoseconds(33'333'333);
}

} // namespace autostereo::devices::kinect2
