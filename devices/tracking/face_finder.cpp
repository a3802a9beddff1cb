#include "devices/tracking/face_finder.hpp"

#include "devices/input.hpp"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <opencv2/imgproc.hpp>
#include <opencv2/objdetect.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace autostereo::devices {

namespace {

constexpr double kSearchedWidth = 320; ///< pixels of the picture in which a face is looked for
constexpr int kLeastFace = 24;         ///< pixels of that
constexpr double kTrackedFace = 60;    ///< pixels of a known face when it is looked for again
/// Every so many pictures the whole one is looked at; a face so much wider takes over.
constexpr std::size_t kWholeEvery = 30;
constexpr double kTakesOver = 1.5;
constexpr double kLit = 45;       ///< mean level to which dark pictures are brought
constexpr double kSizeStep = 1.1; ///< between sizes
constexpr int kFaceNeighbours = 3, kEyeNeighbours = 2;
constexpr double kEyeFace = 130; ///< pixels of a face in which eyes are looked for
constexpr int kLeastEye = 20;

/// The cascades take faces that lean by up to 10 degrees: from which roll on the picture is turned,
/// and how it is, picture by picture, while nobody is found. Radians.
constexpr double kTurnedFrom = 0.1;
constexpr std::array<double, 4> kTriedRolls{0, 0.28, 0, -0.28};

/// Of the face's square: where an eye is looked for, and how far apart eyes can be.
constexpr double kEyeTop = 0.18, kEyeBottom = 0.58, kEyeOuter = 0.08, kEyeInner = 0.52;
constexpr double kLeastSpacing = 0.28, kMostSpacing = 0.56;
constexpr double kMostRise = 0.2; ///< of one eye over the other, of their spacing

/// The spacing to which eyes are brought before pupils are looked for, pixels; an iris' radius of
/// it (11.7 mm across, eyes 63 mm apart); and of the window about an eye half its sides.
constexpr double kPupilSpacing = 60, kIrisShare = 5.85 / 63, kWindowX = 0.26, kWindowY = 0.20;

cv::CascadeClassifier load(const std::filesystem::path& folder, const char* name) {
    const std::filesystem::path file = folder / name;
    cv::CascadeClassifier cascade;
    bool loaded = false;
    try {
        loaded = std::filesystem::exists(file) && cascade.load(file.string());
    } catch (const cv::Exception&) { // no XML
    }
    if (!loaded)
        throw DeviceError(
            "viewer: cannot load " + file.string() + " (Debian's package opencv-data)", true);
    return cascade;
}

glm::dvec2 middleOf(const cv::Rect2d& box) {
    return {box.x + box.width / 2, box.y + box.height / 2};
}

/// A part of a picture at another size: (pixel + 0.5) * scale = (small pixel + 0.5) + origin.
struct Patch {
    cv::Mat pixels;
    glm::dvec2 corner{0}, scale{1};

    Patch(const cv::Mat& picture, const cv::Rect2d& box, double wanted) {
        const cv::Rect whole(0, 0, picture.cols, picture.rows);
        const int left = static_cast<int>(std::floor(box.x)),
                  top = static_cast<int>(std::floor(box.y));
        const cv::Rect part =
            cv::Rect(left, top, static_cast<int>(std::ceil(box.x + box.width)) - left,
                     static_cast<int>(std::ceil(box.y + box.height)) - top) &
            whole;
        if (part.empty()) return;
        const cv::Size size(std::max(1, static_cast<int>(std::lround(part.width * wanted))),
                            std::max(1, static_cast<int>(std::lround(part.height * wanted))));
        cv::resize(picture(part), pixels, size, 0, 0,
                   wanted < 1 ? cv::INTER_AREA : cv::INTER_LINEAR);
        corner = {part.x, part.y};
        scale = {static_cast<double>(size.width) / part.width,
                 static_cast<double>(size.height) / part.height};
    }
    [[nodiscard]] glm::dvec2 inPicture(const glm::dvec2& pixel) const {
        return (pixel + 0.5) / scale - 0.5 + corner;
    }
    [[nodiscard]] cv::Rect2d inPicture(const cv::Rect& box) const {
        return {box.x / scale.x + corner.x, box.y / scale.y + corner.y, box.width / scale.x,
                box.height / scale.y};
    }
};

/// A picture turned about its middle, so that a face leant by `roll` stands upright.
struct Upright {
    cv::Mat pixels;
    cv::Matx23d turn = {1, 0, 0, 0, 1, 0}, back = turn;

    Upright(const cv::Mat& picture, double roll) : pixels(picture) {
        if (roll == 0) return;
        const cv::Point2f middle(0.5F * static_cast<float>(picture.cols - 1),
                                 0.5F * static_cast<float>(picture.rows - 1));
        turn = cv::getRotationMatrix2D(middle, glm::degrees(roll), 1);
        cv::invertAffineTransform(turn, back);
        pixels = cv::Mat(); // not into the picture itself
        cv::warpAffine(picture, pixels, turn, picture.size());
    }
    static glm::dvec2 apply(const cv::Matx23d& map, const glm::dvec2& at) {
        return {map(0, 0) * at.x + map(0, 1) * at.y + map(0, 2),
                map(1, 0) * at.x + map(1, 1) * at.y + map(1, 2)};
    }
};

std::optional<glm::dvec2> pupil(const cv::Mat& picture, const glm::dvec2& eye, double spacing) {
    const cv::Rect2d window(eye.x - kWindowX * spacing, eye.y - kWindowY * spacing,
                            2 * kWindowX * spacing, 2 * kWindowY * spacing);
    const Patch patch(picture, window, kPupilSpacing / spacing);
    if (patch.pixels.empty()) return std::nullopt;
    const GreyView view{
        {patch.pixels.data, patch.pixels.total()}, patch.pixels.cols, patch.pixels.rows};
    const auto centre = pupilCentre(view, kIrisShare * kPupilSpacing);
    if (!centre) return std::nullopt;
    return patch.inPicture(*centre);
}

/// Of an upright face.
bool areEyes(const glm::dvec2& left, const glm::dvec2& right, double face) {
    const glm::dvec2 apart = left - right;
    return apart.x > kLeastSpacing * face && apart.x < kMostSpacing * face &&
           std::abs(apart.y) < kMostRise * apart.x;
}

using Boxes = std::vector<cv::Rect2d>;

Boxes search(cv::CascadeClassifier& cascade, const Patch& patch, int neighbours, int least,
             int most) {
    Boxes boxes;
    if (patch.pixels.empty()) return boxes;
    cv::Mat lit; // cascades pass over windows of little contrast
    patch.pixels.convertTo(lit, -1, std::max(1.0, kLit / std::max(1.0, cv::mean(patch.pixels)[0])));
    std::vector<cv::Rect> found;
    cascade.detectMultiScale(lit, found, kSizeStep, neighbours, 0, {least, least}, {most, most});
    boxes.reserve(found.size());
    for (const cv::Rect& box : found)
        boxes.push_back(patch.inPicture(box));
    return boxes;
}

} // namespace

class FaceFinder::Cascades {
  public:
    explicit Cascades(const std::filesystem::path& folder)
        : face_(load(folder, "haarcascade_frontalface_alt2.xml")),
          eye_(load(folder, "haarcascade_eye.xml")) {}

    [[nodiscard]] std::optional<PupilPair> find(const cv::Mat& picture) {
        ++turn_;
        if (last_) {
            const Upright upright(picture, last_->roll);
            if (turn_ % kWholeEvery == 0)
                if (auto found = look(picture, upright, muchLarger(upright))) return found;
            if (auto found = look(picture, upright, nearLast(upright))) return found;
            last_.reset();
        }
        const Upright upright(picture, kTriedRolls[tries_++ % kTriedRolls.size()]);
        return look(picture, upright, everywhere(upright));
    }

  private:
    /// Where a face was, in the picture as it came.
    struct Face {
        glm::dvec2 middle;
        double width, roll;
    };
    Boxes everywhere(const Upright& upright) {
        const cv::Mat& pixels = upright.pixels;
        const Patch patch(pixels, {0, 0, 1.0 * pixels.cols, 1.0 * pixels.rows},
                          std::min(1.0, kSearchedWidth / pixels.cols));
        Boxes boxes = search(face_, patch, kFaceNeighbours, kLeastFace, patch.pixels.rows);
        std::ranges::sort(boxes, std::greater{}, &cv::Rect2d::width);
        return boxes;
    }
    Boxes muchLarger(const Upright& upright) {
        Boxes boxes = everywhere(upright);
        std::erase_if(boxes,
                      [&](const cv::Rect2d& box) { return box.width < kTakesOver * last_->width; });
        return boxes;
    }
    Boxes nearLast(const Upright& upright) {
        const glm::dvec2 middle = Upright::apply(upright.turn, last_->middle);
        const double width = last_->width;
        const Patch patch(upright.pixels,
                          {middle.x - width, middle.y - width, 2 * width, 2 * width},
                          kTrackedFace / width);
        Boxes boxes = search(face_, patch, kFaceNeighbours, static_cast<int>(0.75 * kTrackedFace),
                             static_cast<int>(1.35 * kTrackedFace));
        std::ranges::sort(
            boxes, {}, [&](const cv::Rect2d& box) { return glm::length(middleOf(box) - middle); });
        return boxes;
    }
    std::optional<PupilPair> look(const cv::Mat& picture, const Upright& upright,
                                  const Boxes& boxes) {
        for (const cv::Rect2d& box : boxes)
            if (const auto pupils = pupilsOf(picture, upright, box)) {
                tries_ = 0;
                const glm::dvec2 across = pupils->left - pupils->right;
                const double roll = std::atan2(across.y, across.x);
                last_ = Face{Upright::apply(upright.back, middleOf(box)), box.width,
                             std::abs(roll) > kTurnedFrom ? roll : 0};
                return pupils;
            }
        return std::nullopt;
    }
    std::optional<glm::dvec2> eye(const cv::Mat& upright, const cv::Rect2d& face, bool onTheLeft);
    std::optional<PupilPair> pupilsOf(const cv::Mat& picture, const Upright& upright,
                                      const cv::Rect2d& face);

    cv::CascadeClassifier face_, eye_;
    std::optional<Face> last_;
    std::size_t turn_ = 0, tries_ = 0;
};

std::optional<glm::dvec2> FaceFinder::Cascades::eye(const cv::Mat& upright, const cv::Rect2d& face,
                                                    bool onTheLeft) {
    const double from = onTheLeft ? kEyeOuter : 1 - kEyeInner;
    const cv::Rect2d region(face.x + from * face.width, face.y + kEyeTop * face.height,
                            (kEyeInner - kEyeOuter) * face.width,
                            (kEyeBottom - kEyeTop) * face.height);
    const Patch patch(upright, region, kEyeFace / face.width);
    const Boxes boxes = search(eye_, patch, kEyeNeighbours, kLeastEye, patch.pixels.rows);
    const glm::dvec2 usual{face.x + (onTheLeft ? 0.31 : 0.69) * face.width,
                           face.y + 0.39 * face.height};
    const auto best = std::ranges::min_element(
        boxes, {}, [&](const cv::Rect2d& box) { return glm::length(middleOf(box) - usual); });
    if (best == boxes.end()) return std::nullopt;
    return middleOf(*best);
}

std::optional<PupilPair> FaceFinder::Cascades::pupilsOf(const cv::Mat& picture,
                                                        const Upright& upright,
                                                        const cv::Rect2d& face) {
    const auto right = eye(upright.pixels, face, true), left = eye(upright.pixels, face, false);
    if (!left || !right || !areEyes(*left, *right, face.width)) return std::nullopt;
    const double spacing = glm::length(*left - *right);
    // In the picture as it came: turned ones are a bit blurred.
    const auto rightPupil = pupil(picture, Upright::apply(upright.back, *right), spacing);
    const auto leftPupil = pupil(picture, Upright::apply(upright.back, *left), spacing);
    if (!leftPupil || !rightPupil ||
        !areEyes(Upright::apply(upright.turn, *leftPupil),
                 Upright::apply(upright.turn, *rightPupil), face.width))
        return std::nullopt;
    return PupilPair{*leftPupil, *rightPupil};
}

FaceFinder::FaceFinder(const std::filesystem::path& cascades)
    : cascades_(std::make_unique<Cascades>(cascades)) {}

FaceFinder::~FaceFinder() = default;

std::optional<PupilPair> FaceFinder::find(const GreyView& picture) {
    cv::setNumThreads(1); // the panel needs the other cores
    // OpenCV has no view of what may not be written; nothing here does.
    const cv::Mat pixels(picture.height, picture.width, CV_8UC1,
                         const_cast<std::uint8_t*>(picture.pixels.data()));
    try {
        return cascades_->find(pixels);
    } catch (const cv::Exception&) { // a size that one of its steps does not take
        return std::nullopt;
    }
}

} // namespace autostereo::devices
