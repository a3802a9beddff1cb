#include "devices/sim/scene_view.hpp"

#include <algorithm>

namespace autostereo::devices::sim {
namespace {

glm::dvec3 directionOf(const calib::RigidTransform& sceneFromCamera, const glm::dvec2& ray) {
    return sceneFromCamera.rotation * glm::dvec3(ray, 1.0);
}

} // namespace

std::optional<Hit> hitAtPixel(const Snapshot& snapshot, const calib::CameraModel& camera,
                              const calib::RigidTransform& sceneFromCamera,
                              const glm::dvec2& pixel) {
    const auto ray = camera.unproject(pixel);
    if (!ray) return std::nullopt;
    return snapshot.trace({sceneFromCamera.translation, directionOf(sceneFromCamera, *ray)});
}

void SceneView::Range::add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
}

bool SceneView::Range::meets(const Range& other) const {
    return least <= other.most && other.least <= most;
}

SceneView::SceneView(const Scene& scene, const calib::CameraModel& camera,
                     const calib::RigidTransform& sceneFromCamera, const PixelSink& background)
    : scene_(scene), sceneFromCamera_(sceneFromCamera),
      columns_(static_cast<std::size_t>(camera.intrinsics.width)),
      rows_(static_cast<std::size_t>(camera.intrinsics.height)) {
    makeRays(camera);
    std::vector<double> nothing(directions_.size());
    for (std::size_t pixel = 0; pixel < nothing.size(); ++pixel) {
        nothing[pixel] = directions_[pixel] == glm::dvec3(0.0) ? 0.0 : kNoHit;
    }
    fixedDistances_ = nothing;
    const Snapshot snapshot = scene_.at(0.0);
    draw(snapshot.fixed(), nothing, [&](std::size_t pixel, const Hit& hit) {
        fixedDistances_[pixel] = hit.distance;
        background(pixel, hit);
    });
}

void SceneView::makeRays(const calib::CameraModel& camera) {
    directions_.reserve(columns_.size() * rows_.size());
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        for (std::size_t column = 0; column < columns_.size(); ++column) {
            const auto ray =
                camera.unproject({static_cast<double>(column), static_cast<double>(row)});
            directions_.push_back(ray ? directionOf(sceneFromCamera_, *ray) : glm::dvec3(0.0));
            if (!ray) continue;
            columns_[column].add(ray->x);
            rows_[row].add(ray->y);
        }
    }
}

std::pair<std::size_t, std::size_t> SceneView::spanOf(const std::vector<Range>& ranges,
                                                      const Range& wanted) {
    const auto meets = [&](const Range& range) { return range.meets(wanted); };
    const auto first = std::find_if(ranges.begin(), ranges.end(), meets);
    const auto last = std::find_if(ranges.rbegin(), std::make_reverse_iterator(first), meets);
    return {static_cast<std::size_t>(first - ranges.begin()),
            static_cast<std::size_t>(last.base() - ranges.begin())};
}

SceneView::PixelBox SceneView::boxAround(const Body& body) const {
    const calib::RigidTransform cameraFromBody = sceneFromCamera_.inverse() * body.sceneFromBody;
    const glm::dvec3 centre = cameraFromBody.translation;
    const glm::dvec3 half = extentsAfter(body, cameraFromBody.rotation);
    const double near = centre.z - half.z, far = centre.z + half.z;
    constexpr double kTooNear = 0.01; // around the camera: x/z has no bounds
    if (near < kTooNear) return {0, columns_.size(), 0, rows_.size()};
    constexpr double kSlack = 1e-9; // rounding of a body that just touches a pixel's centre
    const auto ratios = [&](double middle, double extent) {
        Range range;
        for (const double edge : {middle - extent, middle + extent}) {
            range.add(edge / near - kSlack);
            range.add(edge / near + kSlack);
            range.add(edge / far - kSlack);
            range.add(edge / far + kSlack);
        }
        return range;
    };
    const auto [left, right] = spanOf(columns_, ratios(centre.x, half.x));
    const auto [top, bottom] = spanOf(rows_, ratios(centre.y, half.y));
    return {left, right, top, bottom};
}

void SceneView::draw(std::span<const Body> bodies, const std::vector<double>& behind,
                     const PixelSink& sink) const {
    std::vector<Candidate> candidates;
    for (const Body& body : bodies) {
        candidates.push_back(
            {&body, BodyFromPoint(body, sceneFromCamera_.translation), boxAround(body)});
    }
    RowScratch scratch{std::vector<double>(columns_.size()),
                       std::vector<const Body*>(columns_.size())};
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        drawRow(row, candidates, {&behind[row * columns_.size()], columns_.size()}, scratch, sink);
    }
}

void SceneView::drawRow(std::size_t row, std::span<const Candidate> candidates,
                        std::span<const double> behind, RowScratch& scratch,
                        const PixelSink& sink) const {
    auto& [nearest, seen] = scratch;
    const std::size_t start = row * columns_.size();
    std::size_t left = columns_.size(), right = 0;
    for (const Candidate& candidate : candidates) {
        if (!candidate.box.hasRow(row)) continue;
        left = std::min(left, candidate.box.left);
        right = std::max(right, candidate.box.right);
    }
    for (std::size_t column = left; column < right; ++column) {
        nearest[column] = behind[column];
        seen[column] = nullptr;
    }
    for (const Candidate& candidate : candidates) {
        if (!candidate.box.hasRow(row)) continue;
        for (std::size_t column = candidate.box.left; column < candidate.box.right; ++column) {
            const double distance = candidate.view.distanceAlong(directions_[start + column]);
            if (!(distance < nearest[column])) continue;
            nearest[column] = distance;
            seen[column] = candidate.body;
        }
    }
    for (std::size_t column = left; column < right; ++column) {
        if (seen[column] == nullptr) continue;
        const Ray ray{sceneFromCamera_.translation, directions_[start + column]};
        sink(start + column, shade(*seen[column], ray, nearest[column]));
    }
}

void SceneView::drawMoving(double timeSeconds, const PixelSink& sink) const {
    const Snapshot snapshot = scene_.at(timeSeconds);
    draw(snapshot.moving(), fixedDistances_, sink);
}

} // namespace autostereo::devices::sim
