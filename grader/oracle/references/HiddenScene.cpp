#include <grader/base/SplitMix.h>
#include <grader/oracle/Oracle.h>
#include <grader/oracle/references/HiddenScene.h>

#include <raytracer/base/Error.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ticker::oracle {
namespace {

using raytracer::ColourRGB;
using raytracer::SceneDescription;
using raytracer::SphereDescription;
using raytracer::Vector3;

constexpr int kWidth = 32;
constexpr int kHeight = 24;
constexpr int kCandidates = 200;
constexpr double kGap = 0.05;  // between any two things, world units

/// The same numbers on every machine: splitmix64 (G. Steele, D. Lea and C. Flood, 2014).
class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}

    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(splitMix(state_) >> 11U) * 0x1p-53;
    }
    /// Whole number in [low, high].
    int among(int low, int high) {
        return std::min(high, low + static_cast<int>(between(0.0, high - low + 1.0)));
    }
    ColourRGB colour(double darkest) {
        return {between(darkest, 1.0), between(darkest, 1.0), between(darkest, 1.0)};
    }

private:
    std::uint64_t state_;
};

raytracer::RenderSettings settingsOf(HiddenTask task, Dice& dice) {
    raytracer::RenderSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.lightSize = dice.between(0.35, 0.8);
    settings.dofFocalPlane = dice.between(3.2, 5.0);
    settings.dofAmount =
        task == HiddenTask::depthOfField ? dice.between(0.15, 0.35) : dice.between(0.05, 0.15);
    return settings;
}

raytracer::Material materialOf(Dice& dice) {
    raytracer::Material material;
    material.colour = dice.colour(0.2);
    material.phongKD = dice.between(0.6, 0.9);
    material.phongKS = dice.between(0.2, 1.2);
    material.phongAlpha = dice.among(5, 20);
    material.reflectivity = dice.between(0.0, 0.4);
    return material;
}

double heightAbove(const raytracer::PlaneDescription& plane, const Vector3& point) {
    return (point - plane.point).dot(plane.normal.normalised());
}

// Whether a ball of radius `room` around a point touches nothing.
bool isFree(const SceneDescription& scene, const Vector3& point, double room) {
    for (const SphereDescription& sphere : scene.spheres)
        if ((sphere.centre - point).magnitude() < sphere.radius + room + kGap) return false;
    for (const raytracer::PlaneDescription& plane : scene.planes)
        if (heightAbove(plane, point) < room + kGap) return false;
    return true;
}

void addPlanes(SceneDescription& scene, Dice& dice) {
    raytracer::PlaneDescription floor;
    floor.point = {0.0, dice.between(-1.2, -0.6), 5.0};
    floor.normal = {dice.between(-0.1, 0.1), 1.0, dice.between(-0.25, 0.0)};
    floor.material = materialOf(dice);
    scene.planes.push_back(floor);
    raytracer::PlaneDescription wall;
    wall.point = {0.0, 0.0, dice.between(8.0, 12.0)};
    wall.normal = {dice.between(-0.2, 0.2), 0.0, -1.0};
    wall.material = materialOf(dice);
    scene.planes.push_back(wall);
}

// Spheres stand in view: the picture is 0.41 wide and 0.31 high on each side at distance 1.
void addSpheres(SceneDescription& scene, int count, Dice& dice) {
    for (int tries = 0; tries < 100 && static_cast<int>(scene.spheres.size()) < count; ++tries) {
        SphereDescription sphere;
        const double depth = dice.between(3.0, 7.0);
        sphere.radius = dice.between(0.25, 0.6);
        sphere.centre = {dice.between(-0.36, 0.36) * depth, dice.between(-0.24, 0.2) * depth,
                         depth};
        sphere.material = materialOf(dice);
        if (isFree(scene, sphere.centre, sphere.radius)) scene.spheres.push_back(sphere);
    }
}

void addLights(SceneDescription& scene, int count, double room, Dice& dice) {
    for (int tries = 0; tries < 100 && static_cast<int>(scene.pointLights.size()) < count;
         ++tries) {
        const Vector3 position{dice.between(-3.0, 3.0), dice.between(2.0, 4.0),
                               dice.between(1.0, 5.0)};
        const ColourRGB colour = dice.colour(0.6);
        const double intensity = dice.between(150.0, 350.0) / count;
        if (isFree(scene, position, room))
            scene.pointLights.emplace_back(position, colour, intensity);
    }
}

// Hills of different widths and heights: no symmetry, slopes everywhere.
std::shared_ptr<const raytracer::HeightMap> hillyMap(Dice& dice) {
    constexpr int kColumns = 64;
    constexpr int kRows = 48;
    constexpr int kHills = 24;
    std::vector<double> heights(static_cast<std::size_t>(kColumns * kRows), 0.0);
    for (int hill = 0; hill < kHills; ++hill) {
        const double column = dice.between(0.0, kColumns);
        const double row = dice.between(0.1 * kRows, 0.9 * kRows);
        const double width = dice.between(2.0, 5.0);
        const double height = dice.between(1.0, 3.0);
        for (int j = 0; j < kRows; ++j)
            for (int i = 0; i < kColumns; ++i) {
                const double apart = std::abs(i + 0.5 - column);
                const double across = std::min(apart, kColumns - apart);
                const double down = j + 0.5 - row;
                heights[static_cast<std::size_t>(j * kColumns + i)] +=
                    height * std::exp(-(across * across + down * down) / (width * width));
            }
    }
    for (double& height : heights)
        height = std::min(height, raytracer::kBumpFactor);
    return std::make_shared<const raytracer::HeightMap>(kColumns, kRows, std::move(heights));
}

SceneDescription bumpScene(Dice& dice) {
    SceneDescription scene;
    SphereDescription sphere;
    sphere.radius = dice.between(0.6, 0.9);
    sphere.centre = {dice.between(-0.2, 0.2), dice.between(-0.1, 0.1), dice.between(3.0, 3.6)};
    sphere.material.colour = dice.colour(0.3);
    sphere.heightMap = hillyMap(dice);
    scene.spheres.push_back(sphere);
    addLights(scene, dice.among(1, 2), 0.0, dice);
    return scene;
}

SceneDescription distributedScene(const raytracer::RenderSettings& settings, Dice& dice) {
    SceneDescription scene;
    addPlanes(scene, dice);
    addSpheres(scene, dice.among(2, 4), dice);
    // Twice the room of a right light, so that a mistaken one stands free, too.
    addLights(scene, dice.among(1, 2), 2.0 * settings.lightSize, dice);
    return scene;
}

bool isLegal(const SceneDescription& scene, const raytracer::RenderSettings& settings) {
    const bool filled = !scene.spheres.empty() && !scene.pointLights.empty();
    return filled && isFree(scene, {}, 2.0 * settings.dofAmount);
}

// Neither dark nor burnt out: the mean, and the share of pixels at either end.
bool isLit(const SceneDescription& scene, const raytracer::RenderSettings& settings) {
    Precision rough;
    rough.minLensPaths = rough.maxLensPaths = 32;
    const Moments moments = Oracle{scene, settings}.moments(1, rough);
    double sum = 0.0;
    int extreme = 0;
    for (const ColourRGB& c : moments.mean) {
        sum += c.g;
        if (c.g < 0.01 || c.g > 1.5) ++extreme;
    }
    const auto pixels = static_cast<double>(moments.mean.size());
    return sum / pixels > 0.05 && sum / pixels < 0.8 && extreme < 0.4 * pixels;
}

}  // namespace

HiddenScene hiddenScene(HiddenTask task, std::uint64_t seed) {
    Dice dice{seed ^ (0xA24BAED4963EE407U * (static_cast<std::uint64_t>(task) + 1U))};
    HiddenScene hidden;
    for (; hidden.rejected < kCandidates; ++hidden.rejected) {
        hidden.settings = settingsOf(task, dice);
        hidden.scene =
            task == HiddenTask::bump ? bumpScene(dice) : distributedScene(hidden.settings, dice);
        hidden.scene.ambientLighting = ColourRGB{dice.between(0.02, 0.1)};
        if (!isLegal(hidden.scene, hidden.settings)) continue;
        if (task != HiddenTask::bump && !isLit(hidden.scene, hidden.settings)) continue;
        hidden.separations = separationsOf(task, hidden.scene, hidden.settings);
        hidden.weakest = std::numeric_limits<double>::infinity();
        for (const Separation& separation : hidden.separations)
            hidden.weakest = std::min(hidden.weakest, separation.value);
        if (hidden.weakest >= leastSeparation(task)) return hidden;
    }
    throw raytracer::Error("no informative scene among " + std::to_string(kCandidates) +
                           " candidates");
}

}  // namespace ticker::oracle
