#include "devices/kinect2/parameters_file.hpp"

#include "devices/input.hpp"

#include <nlohmann/json.hpp>

#include <cmath>

namespace autostereo::devices::kinect2 {

namespace {

using nlohmann::json;

/// One camera's numbers and where they stand.
class Numbers {
  public:
    Numbers(const json& file, const char* camera, const std::string& name)
        : where_(name + ": " + camera + '.'), values_(file.value(camera, json::object())) {}

    [[noreturn]] void fail(const std::string& wrong) const { throw DeviceError(where_ + wrong); }
    [[nodiscard]] double at(const std::string& key) const {
        const auto found = values_.is_object() ? values_.find(key) : values_.end();
        if (found == values_.end()) fail(key + ": missing (a number is needed)");
        if (!found->is_number()) fail(key + ": is no number");
        return found->get<double>();
    }
    [[nodiscard]] double within(const std::string& key, double least, double most) const {
        const double value = at(key);
        if (!(value >= least && value <= most))
            fail(key + " = " + std::to_string(value) + " (allowed " + std::to_string(least) +
                 " to " + std::to_string(most) + ')');
        return value;
    }

  private:
    std::string where_;
    json values_;
};

DepthCamera depthFrom(const Numbers& ir) {
    DepthCamera depth;
    depth.model.intrinsics = {kWidth,      kHeight,           ir.at("fx"),
                              ir.at("fy"), ir.at("cx") - 0.5, ir.at("cy") - 0.5};
    auto& lens = depth.model.distortion;
    lens.k1 = ir.at("k1");
    lens.k2 = ir.at("k2");
    lens.p1 = ir.at("p1");
    lens.p2 = ir.at("p2");
    lens.k3 = ir.at("k3");
    if (const auto problem = calib::problemWith(depth.model)) ir.fail(*problem);
    return depth;
}

ColorCalibration colorFrom(const Numbers& color) {
    constexpr std::array kTerms{"x3y0", "x0y3", "x2y1", "x1y2", "x2y0",
                                "x0y2", "x1y1", "x1y0", "x0y1", "x0y0"};
    constexpr double kMostTerm = 1e4; // those of real units are below 1
    ColorCalibration found;
    found.focal = color.within("fx", 100, 10000);
    found.cx = color.within("cx", 0, 1920);
    found.cy = color.within("cy", 0, 1080);
    found.nominalDepthMm = color.within("shift_d", 100, 10000);
    found.displacementMm = color.within("shift_m", -500, 500);
    for (std::size_t i = 0; i < ColorCalibration::kTerms; ++i) {
        found.xTerms[i] = color.within(std::string("mx_") + kTerms[i], -kMostTerm, kMostTerm);
        found.yTerms[i] = color.within(std::string("my_") + kTerms[i], -kMostTerm, kMostTerm);
    }
    return found;
}

} // namespace

Parameters readParameters(const std::string& text, const std::string& name) try {
    const json file = json::parse(text);
    if (!file.is_object()) throw DeviceError(name + ": is no JSON object (allowed ir, color)");
    return {depthFrom({file, "ir", name}), colorFrom({file, "color", name})};
} catch (const json::exception& error) {
    throw DeviceError(name + ": not valid JSON: " + error.what());
}

} // namespace autostereo::devices::kinect2
