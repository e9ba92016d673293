#include <grader/oracle/Setup.h>

#include <raytracer/base/Error.h>
#include <raytracer/base/RenderObserver.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ticker::oracle {
namespace {

constexpr int kNodes = 12;

float narrowed(double value) {
    return static_cast<float>(value);
}

void check(const raytracer::RenderSettings& settings) {
    const int smallest =
        std::min({settings.width, settings.height, settings.imageWidth(), settings.imageHeight(),
                  settings.shadowRayCount, settings.dofRayCount});
    if (smallest < 1) throw raytracer::Error("the oracle needs sizes and ray counts of at least 1");
    if (settings.bounces < 0) throw raytracer::Error("the oracle needs bounces of at least 0");
}

// The cube's corners are sqrt(3) away from its centre; every other shape fits into the unit ball.
double boundOf(LightShape shape) {
    if (shape == LightShape::centre) return 0.0;
    return shape == LightShape::cube ? std::numbers::sqrt3 : 1.0;
}

// Legendre's polynomial of degree n and its derivative, by the three-term recurrence.
std::pair<double, double> legendre(int n, double x) {
    double previous = 0.0;
    double value = 1.0;
    for (int k = 1; k <= n; ++k) {
        const double next = ((2.0 * k - 1.0) * x * value - (k - 1.0) * previous) / k;
        previous = value;
        value = next;
    }
    return {value, n * (x * value - previous) / (x * x - 1.0)};
}

// Gauss-Legendre quadrature of the unit interval with the substitution p = 1 - (1 - z)^2, which
// concentrates the nodes p towards 1.
std::vector<Setup::Node> crowdedNodes(int count) {
    std::vector<Setup::Node> nodes;
    for (int i = 0; i < count; ++i) {
        double x = std::cos(std::numbers::pi * (i + 0.75) / (count + 0.5));
        for (int step = 0; step < 20; ++step) {
            const auto [value, slope] = legendre(count, x);
            x -= value / slope;
        }
        const double slope = legendre(count, x).second;
        const double weight = 1.0 / ((1.0 - x * x) * slope * slope);
        const double rest = 0.5 * (1.0 + x);  // 1 - z
        nodes.push_back({narrowed(1.0 - rest * rest), narrowed(weight * 2.0 * rest)});
    }
    return nodes;
}

}  // namespace

Setup::Setup(const raytracer::SceneDescription& description,
             const raytracer::RenderSettings& renderSettings, const Reading& chosenReading,
             const Mistake& chosenMistake, const Tricks& chosenTricks)
    : scene(description),
      settings(renderSettings),
      reading(chosenReading),
      mistake(chosenMistake),
      tricks(chosenTricks),
      width(settings.imageWidth()),
      height(settings.imageHeight()),
      nodes(crowdedNodes(kNodes)),
      pool(chosenReading.lightShape, renderSettings.lightSize * chosenMistake.lightSizeFactor) {
    check(settings);
    const double step = 2.0 * std::tan(std::numbers::pi / 8.0) / settings.width;
    const bool whole = settings.region.isWholeFrame();
    pitch = narrowed(step);
    leftmost = narrowed(((whole ? 0 : settings.region.x) + 0.5 - settings.width / 2.0) * step);
    topmost = narrowed((settings.height / 2.0 - (whole ? 0 : settings.region.y) - 0.5) * step);
    focal = narrowed(settings.dofFocalPlane * mistake.focalFactor);

    const double half = settings.dofAmount * reading.apertureFactor;
    lensHalf = narrowed(mistake.aperture == Mistake::Aperture::none ? 0.0 : half);
    lensOffsetX = narrowed(half * mistake.lensOffsetX);
    lensOffsetY = narrowed(half * mistake.lensOffsetY);
    pixelSpread = narrowed(reading.pixelSpread);
    lensDimensions = pixelSpread > 0.0F ? 4 : 2;

    const double radius = settings.lightSize * mistake.lightSizeFactor;
    lightRadius = narrowed(radius);
    aimBound = narrowed(radius * boundOf(reading.lightShape));
    for (int axis = 0; axis < 3; ++axis)
        aimOffset[axis] = narrowed(settings.lightSize * mistake.lightOffset[axis]);
    shadowBias = narrowed(reading.shadowBias);
    shadowRays = aimBound > 0.0F || mistake.pointJitter > 0.0 ? settings.shadowRayCount : 1;

    contributionIsShare = reading.phong == PhongReading::central;
    lightIsSplit = mistake.shadowInverted || mistake.ambientScaled || mistake.lightsMixed ||
                   mistake.specularUnshadowed || mistake.diffuseUnshadowed;
    conesHold = tricks.coneTests && mistake.pointJitter == 0.0;
    closedFormsHold = tricks.closedForms && conesHold && contributionIsShare &&
                      reading.lightShape == LightShape::ball && radius > 0.0;
}

bool interrupted(const Setup& setup) {
    return setup.settings.monitor != nullptr && setup.settings.monitor->interrupted();
}

}  // namespace ticker::oracle
