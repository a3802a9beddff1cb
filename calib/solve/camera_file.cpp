#include "calib/solve/camera_file.hpp"

#include "calib/solve/refusal.hpp"

#include <glm/matrix.hpp>
#include <opencv2/core.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace autostereo::calibrate {

namespace {

constexpr int kLargestSide = 16384;
using Words = std::initializer_list<const char*>;

/// A file's root and its name, for complaints.
class Reader {
  public:
    Reader(const std::string& text, std::string name) : name_(std::move(name)) {
        // ROS leaves out the line that OpenCV tells YAML by.
        const bool known = text.starts_with('%') || text.starts_with('<') || text.starts_with('{');
        try {
            storage_.open(known ? text : "%YAML:1.0\n---\n" + text,
                          cv::FileStorage::READ | cv::FileStorage::MEMORY);
        } catch (const cv::Exception& error) {
            throw Refusal(name_ + ": is no YAML, XML or JSON of OpenCV's kind (" + error.err + ')');
        }
        if (!storage_.isOpened()) throw Refusal(name_ + ": cannot be read");
    }

    [[noreturn]] void fail(const std::string& key, const std::string& wrong) const {
        throw Refusal(name_ + ": " + key + ": " + wrong);
    }
    /// The first of these keys, each with `suffix`, that the file has.
    [[nodiscard]] std::string keyOf(Words words, const std::string& suffix) const {
        for (const char* word : words)
            if (!storage_[word + suffix].empty()) return word + suffix;
        return {};
    }
    [[nodiscard]] cv::FileNode at(const std::string& key) const { return storage_[key]; }

    /// A matrix' elements, row by row, or a plain list's.
    [[nodiscard]] std::vector<double> numbers(const std::string& key) const {
        const cv::FileNode node = storage_[key];
        const cv::FileNode data = node.isMap() ? node["data"] : node;
        std::vector<double> values;
        if (!data.isSeq()) fail(key, "is no list of numbers");
        for (const cv::FileNode& value : data) {
            if (!value.isReal() && !value.isInt()) fail(key, "holds what is no number");
            values.push_back(value.real());
            if (!std::isfinite(values.back())) fail(key, "holds what is not finite");
        }
        return values;
    }
    [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t count) const {
        auto values = numbers(key);
        if (values.size() != count)
            fail(key, "has " + std::to_string(values.size()) + " numbers (allowed " +
                          std::to_string(count) + ')');
        return values;
    }

  private:
    std::string name_;
    cv::FileStorage storage_;
};

PictureSize sizeIn(const Reader& file, const std::string& suffix, PictureSize given) {
    const std::string pair = file.keyOf({"size", "image_size", "imageSize"}, suffix);
    const std::string width = file.keyOf({"image_width", "image_Width", "width"}, suffix);
    const std::string height = file.keyOf({"image_height", "image_Height", "height"}, suffix);
    std::vector<double> said;
    if (!pair.empty())
        said = file.numbers(pair, 2);
    else if (!width.empty() && !height.empty())
        said = {file.at(width).real(), file.at(height).real()};
    if (said.empty() && given.width == 0)
        file.fail("image_width", "missing; give the pictures' size");
    if (said.empty()) return given;
    for (const double side : said)
        if (!(side >= 1 && side <= kLargestSide))
            file.fail(pair.empty() ? width : pair, "is out of range (allowed 1 to 16384)");
    return {static_cast<int>(said[0]), static_cast<int>(said[1])};
}

calib::Distortion distortionOf(const Reader& file, const std::string& suffix) {
    const std::string lens = file.keyOf({"distortion_model"}, suffix);
    if (!lens.empty()) {
        const std::string model = file.at(lens).string();
        if (model != "plumb_bob" && model != "rational_polynomial")
            file.fail(lens, model + " is not known (allowed plumb_bob, rational_polynomial)");
    }
    const std::string key =
        file.keyOf({"distortion_coefficients", "distortionCoefficients", "Distortion_Coefficients",
                    "distCoeffs", "dist_coeffs", "D"},
                   suffix);
    calib::Distortion k;
    if (key.empty()) return k;
    const auto terms = file.numbers(key);
    constexpr std::size_t kKnown = 8;
    const std::array<double*, kKnown> places{&k.k1, &k.k2, &k.p1, &k.p2,
                                             &k.k3, &k.k4, &k.k5, &k.k6};
    for (std::size_t i = 0; i < terms.size(); ++i) {
        if (i < kKnown)
            *places.at(i) = terms[i];
        else if (terms[i] != 0)
            file.fail(key, "has thin-prism or tilt terms (allowed up to eight, k1 k2 p1 p2 k3 k4 "
                           "k5 k6)");
    }
    return k;
}

std::optional<calib::CameraModel> cameraIn(const Reader& file, const std::string& suffix,
                                           PictureSize given) {
    const std::string key = file.keyOf(
        {"camera_matrix", "cameraMatrix", "Camera_Matrix", "intrinsic_matrix", "K", "M"}, suffix);
    if (key.empty()) return std::nullopt;
    const auto m = file.numbers(key, 9);
    if (m[1] != 0 || m[3] != 0 || m[6] != 0 || m[7] != 0 || m[8] != 1)
        file.fail(key, "is no camera matrix (allowed fx 0 cx 0 fy cy 0 0 1)");
    const PictureSize size = sizeIn(file, suffix, given);
    const calib::CameraModel camera{{size.width, size.height, m[0], m[4], m[2], m[5]},
                                    distortionOf(file, suffix)};
    if (const auto problem = calib::problemWith(camera)) file.fail(key, *problem);
    return camera;
}

std::optional<calib::RigidTransform> transformIn(const Reader& file, double unitM) {
    constexpr double kFarthest = 2, kTolerance = 1e-3;
    const std::string turn = file.keyOf({"R", "rotation"}, "");
    const std::string shift = file.keyOf({"T", "translation"}, "");
    if (turn.empty() || shift.empty()) return std::nullopt;
    const auto r = file.numbers(turn, 9), t = file.numbers(shift, 3);
    calib::RigidTransform found;
    for (glm::length_t row = 0; row < 3; ++row) {
        for (glm::length_t column = 0; column < 3; ++column)
            found.rotation[column][row] =
                r[3 * static_cast<std::size_t>(row) + static_cast<std::size_t>(column)];
        found.translation[row] = unitM * t[static_cast<std::size_t>(row)];
        if (!(std::abs(found.translation[row]) < kFarthest))
            file.fail(shift, "puts the cameras more than 2 m apart (is it in millimetres?)");
    }
    const glm::dmat3 product = found.rotation * glm::transpose(found.rotation);
    for (glm::length_t i = 0; i < 3; ++i)
        for (glm::length_t j = 0; j < 3; ++j)
            if (std::abs(product[i][j] - (i == j ? 1 : 0)) > kTolerance ||
                glm::determinant(found.rotation) < 0)
                file.fail(turn, "is no rotation");
    return found;
}

} // namespace

CameraFile readCameraFile(const std::string& text, const std::string& name, PictureSize size,
                          double unitM) try {
    const Reader file(text, name);
    CameraFile found;
    found.first = cameraIn(file, "", size);
    if (!found.first) {
        found.first = cameraIn(file, "1", size);
        found.second = cameraIn(file, "2", size);
    }
    found.secondFromFirst = transformIn(file, unitM);
    if (!found.first && !found.second && !found.secondFromFirst)
        file.fail("camera_matrix", "missing (allowed camera_matrix, cameraMatrix, K, M1 and M2, or "
                                   "rotation and translation)");
    return found;
} catch (const cv::Exception& error) {
    throw Refusal(name + ": cannot be read: " + error.err);
}

} // namespace autostereo::calibrate
