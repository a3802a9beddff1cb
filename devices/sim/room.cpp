#include "devices/sim/room.hpp"

#include "devices/sim/placement.hpp"

namespace autostereo::devices::sim {
namespace {

constexpr double kTableTopY = 0.40;

void append(std::vector<Body>& bodies, std::vector<Body> more) {
    bodies.insert(bodies.end(), more.begin(), more.end());
}

std::vector<Body> wallFurniture(std::uint32_t seed) {
    const glm::dvec3 oak{176, 122, 76};
    const double pictureZ = kBackWallZ - 0.012;
    return {
        {Shape::Box,
         standing({-0.42, -0.42, pictureZ}),
         {0.52, 0.36, 0.012},
         {landscape, {92, 60, 38}, 0.45, 0, seed + 10}},
        {Shape::Box,
         standing({0.66, -0.50, pictureZ}),
         {0.27, 0.35, 0.012},
         {abstractArt, {40, 38, 40}, 0.55, 0, seed + 20}},
        {Shape::Box,
         standing({1.62, 0.05, kBackWallZ - 0.15}),
         {0.44, 1.05, 0.15},
         {bookSpines, oak, 0.42, 0, seed + 30}},
        // Sideboard with a vase below the landscape.
        {Shape::Box,
         standing({-0.45, 0.74, kBackWallZ - 0.21}),
         {0.70, 0.36, 0.21},
         {woodGrain, {150, 98, 62}, 0.48, 0, seed + 40}},
        {Shape::Ellipsoid,
         standing({-0.85, 0.25, 2.98}),
         {0.085, 0.13, 0.085},
         {mottled, {52, 120, 140}, 0.50, 2.0, seed + 41}},
        {Shape::Cylinder,
         standing({-0.85, 0.11, 2.98}),
         {0.035, 0.05, 0.035},
         {mottled, {52, 120, 140}, 0.50, 0, seed + 41}},
        {Shape::Box,
         standing({-0.12, 0.335, 2.97}, 0.3),
         {0.15, 0.045, 0.11},
         {woodGrain, {196, 84, 66}, 0.40, 0, seed + 42}},
    };
}

std::vector<Body> lampAndPlant(std::uint32_t seed) {
    std::vector<Body> bodies{
        // Floor lamp: the thin pole is 16 mm wide.
        {Shape::Capsule,
         between({-1.05, -0.40, 1.95}, {-1.05, kFloorY, 1.95}),
         {0.008, 0.75, 0},
         {plain, {70, 64, 60}, 0.35, 1.0, 0}},
        {Shape::Cylinder,
         standing({-1.05, kFloorY - 0.015, 1.95}),
         {0.14, 0.015, 0},
         {plain, {70, 64, 60}, 0.35, 0, 0}},
        {Shape::Cylinder,
         standing({-1.05, -0.42, 1.95}),
         {0.15, 0.13, 0},
         {stripes, {252, 214, 150}, 0.70, 0, seed + 50}},
        {Shape::Cylinder,
         standing({-1.62, 0.90, 2.55}),
         {0.17, 0.20, 0},
         {mottled, {178, 96, 66}, 0.50, 0, seed + 51}},
        // Rug.
        {Shape::Cylinder,
         standing({-0.30, kFloorY, 2.1}),
         {0.85, 0.008, 0},
         {mottled, {168, 70, 62}, 0.45, 0, seed + 52}},
    };
    const glm::dvec3 crown{-1.62, 0.42, 2.55};
    const glm::dvec3 leaves[] = {{0, 0, 0},           {0.16, -0.20, -0.05}, {-0.15, -0.16, 0.02},
                                 {0.02, -0.40, 0.03}, {0.10, 0.10, -0.14},  {-0.12, 0.09, -0.12}};
    for (const glm::dvec3& leaf : leaves) {
        bodies.push_back({Shape::Ellipsoid,
                          standing(crown + leaf),
                          {0.15, 0.20, 0.14},
                          {mottled, {78, 132, 66}, 0.75, 0, seed + 53}});
    }
    return bodies;
}

std::vector<Body> table(std::uint32_t seed) {
    const Material oak{woodGrain, {196, 142, 90}, 0.50, 0, seed + 60};
    std::vector<Body> bodies{
        {Shape::Box,
         {turn(1.5707963267948966, {0, 1, 0}), {0.86, kTableTopY + 0.02, 1.70}},
         {0.75, 0.02, 0.52},
         oak}};
    for (const double x : {0.42, 1.30}) {
        for (const double z : {1.05, 2.35}) {
            const glm::dvec3 foot{x, kFloorY, z};
            bodies.push_back({Shape::Cylinder,
                              between(foot, {x, kTableTopY + 0.03, z}),
                              {0.03, 0.5 * (kFloorY - kTableTopY - 0.03), 0},
                              oak});
        }
    }
    return bodies;
}

/// Standing on the table: `height` is half the body's.
calib::RigidTransform onTable(double x, double z, double height, double yaw = 0) {
    return standing({x, kTableTopY - height, z}, yaw);
}

std::vector<Body> tableObjects(std::uint32_t seed) {
    const glm::dvec3 porcelain{236, 234, 226};
    return {
        // A glossy ball, a parcel, a tin: the first surfaces in front, one metre away.
        {Shape::Ellipsoid,
         onTable(0.50, 1.10, 0.075),
         {0.075, 0.075, 0.075},
         {mottled, {206, 54, 48}, 0.60, 7.0, seed + 70}},
        {Shape::Box,
         onTable(0.78, 1.42, 0.09, 0.5),
         {0.13, 0.09, 0.09},
         {stripes, {64, 112, 158}, 0.55, 0, seed + 71}},
        {Shape::Cylinder,
         onTable(0.46, 1.62, 0.11),
         {0.055, 0.11, 0},
         {stripes, {74, 140, 92}, 0.60, 0, seed + 72}},
        // A black bowl that a time-of-flight camera hardly sees, and a white jug.
        {Shape::Ellipsoid,
         onTable(0.80, 1.86, 0.05),
         {0.13, 0.05, 0.13},
         {mottled, {36, 36, 42}, 0.035, 0, seed + 73}},
        {Shape::Cylinder,
         onTable(1.12, 2.05, 0.15),
         {0.075, 0.15, 0},
         {mottled, porcelain, 0.85, 0, seed + 74}},
        {Shape::Capsule,
         between({1.20, kTableTopY - 0.07, 2.05}, {1.20, kTableTopY - 0.23, 2.05}),
         {0.012, 0.08, 0},
         {plain, porcelain, 0.85, 0, 0}},
        {Shape::Ellipsoid,
         onTable(0.58, 2.30, 0.14),
         {0.14, 0.14, 0.14},
         {stripes, {232, 170, 60}, 0.65, 0, seed + 75}},
        // A card that leans back and is turned aside.
        {Shape::Box,
         {turn(0.45, {0, 1, 0}) * turn(-0.42, {1, 0, 0}), {1.02, kTableTopY - 0.125, 1.62}},
         {0.10, 0.135, 0.002},
         {abstractArt, {246, 240, 226}, 0.80, 0, seed + 76}},
    };
}

} // namespace

std::vector<Body> emptyRoom(const glm::dvec3& walls, std::uint32_t seed) {
    const glm::dvec3 low{-kSideWallX, kCeilingY, kFrontWallZ};
    const glm::dvec3 high{kSideWallX, kFloorY, kBackWallZ};
    constexpr double kFloorBoard = 0.002; // laid on the floor of the box
    return {
        {Shape::Box,
         standing(0.5 * (low + high)),
         0.5 * (high - low),
         {plaster, walls, 0.72, 0, seed + 1}},
        {Shape::Box,
         standing({0, kFloorY + kFloorBoard, 0.5 * (low.z + high.z)}),
         {kSideWallX, 2 * kFloorBoard, 0.5 * (high.z - low.z)},
         {floorBoards, {188, 134, 86}, 0.45, 0, seed + 4}},
    };
}

std::vector<Body> furnishedRoom(std::uint32_t seed) {
    std::vector<Body> bodies = emptyRoom({226, 204, 170}, seed);
    append(bodies, wallFurniture(seed));
    append(bodies, lampAndPlant(seed));
    append(bodies, table(seed));
    append(bodies, tableObjects(seed));
    return bodies;
}

} // namespace autostereo::devices::sim
