#include <grader/tasks/lens/answers/LensLog.h>
#include <grader/tasks/lens/questions/LensQuestions.h>
#include <grader/tasks/lens/questions/MixedRenders.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/Surfaces.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

namespace ticker::tasks {
namespace {

// 6 x 4 pixels, two repetitions, 50 rays: 2400 lens points.
constexpr int kWidth = 6;
constexpr int kHeight = 4;
constexpr int kRepetitions = 2;

// A mean without the misses differs from the mean only if a pixel has hits and misses. At least
// kMixedPixels pixels have a share of kLeastShare or more of both, and some have no misses.
constexpr int kMixedPixels = 3;
constexpr double kLeastShare = 0.2;
constexpr int kLensGrid = 6;

// Primes, so that groups of any size leave some rays over. Below the handout's number, so that code
// with that number hard-coded casts enough. A loop that adds 1.0 / n until it reaches 1 runs n + 1
// times for each of them.
constexpr std::array kOddRays{29, 31, 37};

// Share of the lens points from which the rays to `focus` hit nothing.
double missedShare(const Surfaces& surfaces, const Vector3& focus, double halfWidth) {
    int missed = 0;
    for (int i = 0; i < kLensGrid * kLensGrid; ++i) {
        const int column = i % kLensGrid;
        const int row = i / kLensGrid;
        const double x = 2.0 * (column + 0.5) / kLensGrid - 1.0;
        const double y = 2.0 * (row + 0.5) / kLensGrid - 1.0;
        const Vector3 lens = Vector3{x, y, 0.0} * halfWidth;
        const Sight sight = surfaces.sightAlong(lens, (focus - lens).normalised(),
                                                std::numeric_limits<double>::infinity());
        if (sight == Sight::open) ++missed;
    }
    return static_cast<double>(missed) / (kLensGrid * kLensGrid);
}

// Whether hits and misses are mixed as required, with the apertures of both readings.
bool isMixed(const raytracer::SceneDescription& scene, const raytracer::RenderSettings& settings) {
    const Surfaces surfaces{scene};
    for (const double halfWidth : {settings.dofAmount, settings.dofAmount / 2.0}) {
        int mixed = 0;
        int whole = 0;
        for (int i = 0; i < settings.width * settings.height; ++i) {
            const Vector3 pinhole =
                pinholeDirection(settings, i % settings.width, i / settings.width);
            const double share =
                missedShare(surfaces, pinhole * (settings.dofFocalPlane / pinhole.z), halfWidth);
            if (std::clamp(share, kLeastShare, 1.0 - kLeastShare) == share) ++mixed;
            if (share == 0.0) ++whole;
        }
        if (mixed < kMixedPixels || whole == 0) return false;
    }
    return true;
}

enum class Depth { nothing, sharp, between, blurred };

// How sharp the surface is that a ray from the eye meets, by its distance in z from the focal
// plane. `between` if it is neither clearly sharp nor clearly blurred.
Depth depthAlong(const Surfaces& surfaces, const Vector3& direction, double focalPlane) {
    constexpr double kNear = 0.3;
    constexpr double kFar = 0.5;
    const auto sightTo = [&](double z) {
        return surfaces.sightAlong({}, direction, z / direction.z);
    };
    if (sightTo(std::numeric_limits<double>::infinity()) != Sight::blocked) return Depth::nothing;
    if (sightTo(focalPlane - kFar) == Sight::blocked) return Depth::blurred;
    if (sightTo(focalPlane + kFar) == Sight::open) return Depth::blurred;
    const bool isSharp =
        sightTo(focalPlane - kNear) == Sight::open && sightTo(focalPlane + kNear) == Sight::blocked;
    return isSharp ? Depth::sharp : Depth::between;
}

// Whether two mistakes are visible in the scene. Code that focuses on what the axis or the middle
// pixel shows differs from right code only if that is out of focus. Code that skips the lens in
// pixels that are nearly sharp differs only if there is such a pixel.
bool showsDepths(const raytracer::SceneDescription& scene,
                 const raytracer::RenderSettings& settings) {
    const Surfaces surfaces{scene};
    const auto depthOf = [&](int x, int y) {
        return depthAlong(surfaces, pinholeDirection(settings, x, y), settings.dofFocalPlane);
    };
    if (depthAlong(surfaces, {0.0, 0.0, 1.0}, settings.dofFocalPlane) != Depth::blurred ||
        depthOf(settings.width / 2, settings.height / 2) != Depth::blurred)
        return false;
    for (int i = 0; i < settings.width * settings.height; ++i)
        if (depthOf(i % settings.width, i / settings.width) == Depth::sharp) return true;
    return false;
}

raytracer::RenderSettings handoutSettings() {
    raytracer::RenderSettings handout;
    handout.width = kWidth;
    handout.height = kHeight;
    return handout;
}

probe::RenderQuestion drawQuestion(Draw& draw, const raytracer::RenderSettings& settings,
                                   int repetitions) {
    raytracer::SceneDescription scene;
    do
        scene = drawBalls(draw);
    while (!showsDepths(scene, settings) || !isMixed(scene, settings));
    return renderOf(draw, std::move(scene), settings, repetitions);
}

}  // namespace

LensQuestions drawLensQuestions(std::uint64_t seed) {
    Draw draw{seed, 22};
    LensQuestions questions;
    questions.handout = drawQuestion(draw, handoutSettings(), kRepetitions);

    raytracer::RenderSettings other;
    other.width = 4;
    other.height = 3;
    other.dofRayCount = draw.whole(90, 110);
    other.dofFocalPlane = draw.between(4.5, 6.0);
    other.dofAmount = draw.between(0.28, 0.35);
    other.bounces = 1;
    questions.other = drawQuestion(draw, other, 1);

    Draw drawOdd{seed, 29};
    raytracer::RenderSettings odd;
    odd.width = 4;
    odd.height = 3;
    odd.dofRayCount = kOddRays[static_cast<std::size_t>(drawOdd.whole(0, 2))];
    questions.odd = drawQuestion(drawOdd, odd, 1);
    Draw drawMany{seed, 31};
    raytracer::RenderSettings many;
    many.width = many.height = 2;
    many.dofRayCount = drawMany.whole(280, 320);
    questions.many = renderOf(drawMany, drawBalls(drawMany), many);
    questions.mixed = drawMixedRenders(seed);
    return questions;
}

probe::RenderQuestion drawThreadsQuestion(std::uint64_t seed) {
    Draw draw{seed, 25};
    raytracer::RenderSettings settings = handoutSettings();
    settings.threads = 2;
    // An odd number of rows: code that gives each thread height / threads rows leaves one out.
    settings.height = kHeight + 1;
    return drawQuestion(draw, settings, 1);
}

NextRender drawNextRender(std::uint64_t seed) {
    Draw draw{seed, 27};
    NextRender renders;
    renders.next = drawQuestion(draw, handoutSettings(), 1);
    renders.before = drawQuestion(draw, handoutSettings(), 1);
    raytracer::RenderSettings& before = renders.before.settings;
    before.width = 3 * kWidth;
    before.height = 3 * kHeight;
    before.region = {draw.whole(0, 2 * kWidth), 2 * kHeight, kWidth, kHeight};
    return renders;
}

probe::RenderQuestion drawScreenQuestion(std::uint64_t seed) {
    Draw draw{seed, 28};
    raytracer::RenderSettings settings;
    settings.width = 4;
    settings.height = 3;
    return drawQuestion(draw, settings, 1);
}

probe::RenderQuestion drawFineQuestion(std::uint64_t seed) {
    // A few rays for each pixel suffice; code with the handout's count as a constant still fits
    // into the log.
    constexpr int kRays = 10;
    Draw draw{seed, 26};
    raytracer::RenderSettings settings;
    settings.height = 2;
    settings.dofRayCount = kRays;
    return renderOf(draw, drawBalls(draw), settings);
}

}  // namespace ticker::tasks
