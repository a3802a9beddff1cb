#include "devices/join_inputs.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace autostereo::devices {

Input joined(Input depth, Input color, const std::optional<calib::SensorRig>& rig) {
    if (!depth.depth) throw DeviceError(depth.uri + ": it has no depth to go with " + color.uri);
    if (!color.color) throw DeviceError(color.uri + ": it has no colour to go with " + depth.uri);
    Input both = std::move(depth);
    both.description += "; " + color.description;
    both.color = std::move(color.color);
    both.reopen.color = std::move(color.reopen.color);
    both.colorIsLive = color.colorIsLive;
    if (both.rig && color.rig) {
        both.rig->color = color.rig->color;
        if (!rig) {
            both.rig->colorFromDepth = {};
            both.warnings.push_back("nothing is known of how " + both.uri + " and " + color.uri +
                                    " stand to each other: give --rig");
        }
    }
    std::ranges::move(color.warnings, std::back_inserter(both.warnings));
    return both;
}

} // namespace autostereo::devices
