#include "devices/kinect2/usb/open_unit.hpp"

#include "devices/kinect2/raw/raw_recorder.hpp"
#include "devices/kinect2/usb/unit_sources.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

namespace autostereo::devices::kinect2 {

namespace {

std::string listed(const std::vector<UnitNode>& units) {
    std::string all;
    for (const UnitNode& unit : units)
        all += (all.empty() ? "" : ", ") + unit.serial + " on port " + unit.port;
    return all.empty() ? "there is none" : "there are " + all;
}

UnitNode find(const std::string& serial) {
    const std::vector<UnitNode> units = findUnits();
    const auto found =
        serial.empty() ? units.begin() : std::ranges::find(units, serial, &UnitNode::serial);
    if (found != units.end()) return *found;
    throw DeviceError("kinect2: cannot open kinect2:" + serial + ": no such camera (" +
                          listed(units) + "; it needs USB 3 and its power supply)",
                      true);
}

/// The one running unit behind both sources; whichever asks first after a loss opens it again.
/// Thread-safe.
class SharedUnit {
  public:
    explicit SharedUnit(UnitNode node) : node_(std::move(node)) {}

    [[nodiscard]] std::shared_ptr<Unit> get() {
        const std::lock_guard lock(mutex_);
        std::shared_ptr<Unit> unit = unit_.lock();
        if (unit && !unit->lost()) return unit;
        // Its calibration is this unit's: another one would not do.
        if (opened_) node_ = find(node_.serial);
        unit = std::make_shared<Unit>(node_, patience_, tap_);
        opened_ = true;
        unit_ = unit;
        return unit;
    }

    /// Gets what this unit sends, from now on.
    void setTap(std::shared_ptr<RawTap> tap) {
        const std::lock_guard lock(mutex_);
        tap_ = std::move(tap);
        if (const auto unit = unit_.lock()) unit->setTap(tap_);
    }

  private:
    std::mutex mutex_;
    UnitNode node_;
    bool opened_ = false;
    std::shared_ptr<UnitPatience> patience_ = std::make_shared<UnitPatience>();
    std::shared_ptr<RawTap> tap_;
    std::weak_ptr<Unit> unit_;
};

} // namespace

Input openKinect2(const Uri& uri, const std::optional<calib::SensorRig>& rig) {
    uri.allowOnly({});
    const UnitNode node = find(uri.path);
    Input input;
    input.uri = uri.text;
    for (const std::string& problem : problemsWith(node))
        input.warnings.push_back("kinect2 " + node.serial + ": " + problem);
    const auto shared = std::make_shared<SharedUnit>(node);
    const auto continuity = std::make_shared<UnitContinuity>();
    const std::shared_ptr<Unit> unit = shared->get();
    describe(input, unit->facts(), rig);
    input.depth = std::make_unique<DepthSource>(unit, continuity);
    input.color = std::make_unique<ColorSource>(unit, continuity);
    input.reopen.depth = [shared, continuity]() -> std::unique_ptr<Source> {
        return std::make_unique<DepthSource>(shared->get(), continuity);
    };
    input.reopen.color = [shared, continuity]() -> std::unique_ptr<Source> {
        return std::make_unique<ColorSource>(shared->get(), continuity);
    };
    input.recordRaw = [shared](const std::filesystem::path& file) {
        auto recorder = std::make_shared<RawRecorder>(file);
        shared->setTap(recorder);
        return recorder;
    };
    input.depthIsLive = input.colorIsLive = true;
    return input;
}

} // namespace autostereo::devices::kinect2
