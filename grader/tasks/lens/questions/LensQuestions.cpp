#include <grader/tasks/lens/answers/LensLog.h>
#include <grader/tasks/lens/questions/LensQuestions.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/Surfaces.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace ticker::tasks {
namespace {

// 6 x 4 pixels, two repetitions, 50 rays: 2400 lens points.
constexpr int kWidth = 6;
constexpr int kHeight = 4;
constexpr int kRepetitions = 2;
constexpr int kSpheres = 24;

// Events of one lens ray: trace and illuminate begin and end, one ray is cast; the camera's ray and
// the pixel come on top. The log holds four times as many.
constexpr std::size_t kEventsForEachRay = 24;

// A mean without the misses differs from the mean only if a pixel has hits and misses. At least
// this many pixels have both, and some have no misses.
constexpr int kMixedPixels = 3;
constexpr double kLeastShare = 0.2;
constexpr int kLensGrid = 6;

// Primes: no groups of any size make them up. Below the handout's number, so that code with that
// one typed in casts enough; 49 would be rounded up to it.
constexpr std::array kOddRays{41, 43, 47};

// Spheres of many colours at all depths, so that neighbouring rays see different things.
raytracer::SceneDescription drawScene(Draw& draw) {
    raytracer::SceneDescription scene;
    // Colours above and below 1, so that clamping shows.
    scene.ambientLighting = draw.colour(2.0, 4.0);
    for (int i = 0; i < kSpheres; ++i) {
        raytracer::Material material;
        material.colour = draw.colour(0.05, 1.0);
        material.reflectivity = 0.0;
        const double z = draw.between(1.8, 8.0);
        const double x = draw.between(-0.42, 0.42) * z;
        const Vector3 centre{x, draw.between(-0.3, 0.3) * z, z};
        scene.spheres.push_back({centre, draw.between(0.04, 0.1) * z, material, nullptr});
    }
    // Above the floor some rays hit nothing.
    raytracer::Material floor;
    floor.colour = draw.colour(0.2, 0.8);
    floor.reflectivity = 0.0;
    scene.planes.push_back({{0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}, floor});
    return scene;
}

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

// How far what a ray from the eye shows lies from the focal plane. Rounding counts as `between`.
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

// Code that focuses on what the centre shows, along the axis or in the middle pixel, differs from
// right code only if that is out of focus; code that spares the lens where a pixel is nearly sharp
// only if one is.
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
    probe::RenderQuestion question;
    do
        question.scene = drawScene(draw);
    while (!showsDepths(question.scene, settings) || !isMixed(question.scene, settings));
    question.settings = settings;
    question.settings.seed = draw.word() >> 1U;
    question.repetitions = repetitions;
    const auto pixels = static_cast<std::size_t>(settings.width * settings.height * repetitions);
    question.eventCapacity = static_cast<std::uint32_t>(
        pixels * static_cast<std::size_t>(settings.dofRayCount) * kEventsForEachRay);
    return question;
}

// So few pixels that it takes no longer than the others. What they show does not matter.
probe::RenderQuestion drawAny(Draw& draw, const raytracer::RenderSettings& settings) {
    probe::RenderQuestion question;
    question.scene = drawScene(draw);
    question.settings = settings;
    question.settings.seed = draw.word() >> 1U;
    const int rays = settings.width * settings.height * settings.dofRayCount;
    question.eventCapacity =
        static_cast<std::uint32_t>(static_cast<std::size_t>(rays) * kEventsForEachRay);
    return question;
}

raytracer::RenderSettings fewPixels() {
    raytracer::RenderSettings settings;
    settings.width = 4;
    settings.height = 3;
    return settings;
}

void drawLimits(LensQuestions& questions, std::uint64_t seed) {
    Draw draw{seed, 30};
    raytracer::RenderSettings many;
    many.width = many.height = 2;
    many.dofRayCount = draw.whole(280, 320);
    questions.many = drawAny(draw, many);
    raytracer::RenderSettings near = fewPixels();
    near.dofFocalPlane = draw.between(0.6, 0.8);
    near.dofAmount = draw.between(0.28, 0.32);
    questions.near = drawAny(draw, near);
    raytracer::RenderSettings far = fewPixels();
    far.dofFocalPlane = draw.between(25.0, 40.0);
    far.dofAmount = draw.between(0.02, 0.04);
    questions.far = drawAny(draw, far);
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
    drawLimits(questions, seed);
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
    probe::RenderQuestion question;
    question.scene = drawScene(draw);
    question.settings.height = 2;
    question.settings.dofRayCount = kRays;
    question.settings.seed = draw.word() >> 1U;
    question.eventCapacity = static_cast<std::uint32_t>(
        static_cast<std::size_t>(question.settings.width * question.settings.height * kRays) *
        kEventsForEachRay);
    return question;
}

}  // namespace ticker::tasks
