#include <grader/tasks/lens/answers/LensLog.h>
#include <grader/tasks/lens/questions/MixedRenders.h>
#include <grader/tasks/support/Channels.h>
#include <grader/tasks/support/Deck.h>
#include <grader/tasks/support/Surfaces.h>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace ticker::tasks {
namespace {

using raytracer::RenderSettings;
using raytracer::SceneDescription;

constexpr int kRenders = 7;
constexpr int kBalls = 24;

// Events of one lens ray: trace and illuminate begin and end, one ray is cast; the camera's ray and
// the pixel come on top. The log holds four times as many.
constexpr std::size_t kEventsForEachRay = 24;

// Limits of the ambient light's brightest channel: `wordsOf` calls a scene below kDark dark, and
// one above kBright very bright.
constexpr double kDark = 0.01;
constexpr double kBright = 100.0;

// `wordsOf` calls a surface this near to the focal plane one in the focal plane.
constexpr double kInFocus = 1e-9;

enum class Shows : std::uint8_t { usual, nothing, black, dark, bright, mirrors, close };

struct Size {
    int width = 0;
    int height = 0;
};

SceneDescription drawScene(Draw& draw, Shows shows) {
    SceneDescription scene = drawBalls(draw);
    switch (shows) {
        case Shows::usual:
            break;
        case Shows::nothing:
            scene.spheres.clear();
            scene.planes.clear();
            break;
        case Shows::black:
            scene.ambientLighting = ColourRGB{0.0};
            break;
        case Shows::dark:
            scene.ambientLighting = ColourRGB{kDark / 5.0};
            break;
        case Shows::bright:
            scene.ambientLighting = ColourRGB{3.0 * kBright};
            break;
        case Shows::mirrors:
            for (auto& sphere : scene.spheres)
                sphere.material.reflectivity = draw.whole(0, 1) == 0 ? 1.0 : 0.5;
            break;
        case Shows::close:
            for (auto& sphere : scene.spheres) {
                const double share = draw.between(0.2, 0.9) / sphere.centre.z;
                sphere.centre = sphere.centre * share;
                sphere.radius *= share;
            }
    }
    return scene;
}

// z of what the centre of each pixel shows; infinite where it shows nothing.
std::vector<double> depthsOf(const SceneDescription& scene, const RenderSettings& settings) {
    const Surfaces surfaces{scene};
    std::vector<double> depths;
    for (int i = 0; i < settings.width * settings.height; ++i) {
        const Vector3 pinhole = pinholeDirection(settings, i % settings.width, i / settings.width);
        depths.push_back(surfaces.hitsAlong({}, pinhole).plain * pinhole.z);
    }
    return depths;
}

bool showsFocalPlane(const SceneDescription& scene, const RenderSettings& settings) {
    return std::ranges::any_of(depthsOf(scene, settings), [&](double depth) {
        return std::abs(depth - settings.dofFocalPlane) < kInFocus;
    });
}

// A render whose focal plane goes exactly through what a pixel shows. Code that casts one ray where
// a pixel is sharp is wrong there, whatever its threshold for sharpness.
probe::RenderQuestion drawInFocus(std::uint64_t seed) {
    Draw draw{seed, 32};
    RenderSettings settings;
    settings.width = 4;
    settings.height = 3;
    SceneDescription scene;
    std::vector<double> shown;
    do {
        scene = drawBalls(draw);
        shown = depthsOf(scene, settings);
        std::erase_if(shown, [](double depth) { return !(depth > 1.5 && depth < 8.0); });
    } while (shown.empty());
    const auto one = draw.whole(0, static_cast<int>(shown.size()) - 1);
    settings.dofFocalPlane = shown[static_cast<std::size_t>(one)];
    return renderOf(draw, std::move(scene), settings);
}

std::string sceneWords(const SceneDescription& scene) {
    if (scene.spheres.empty() && scene.planes.empty()) return "an empty scene";
    const double ambient = largestChannel(scene.ambientLighting);
    if (ambient < kDark) return "a dark scene";
    if (ambient > kBright) return "a very bright scene";
    if (scene.spheres.front().material.reflectivity > 0.0) return "a scene with mirrors";
    if (std::ranges::all_of(scene.spheres, [](const auto& ball) { return ball.centre.z < 1.0; }))
        return "a scene with objects nearer than 1";
    return "another scene";
}

}  // namespace

SceneDescription drawBalls(Draw& draw) {
    SceneDescription scene;
    scene.ambientLighting = draw.colour(2.0, 4.0);
    for (int i = 0; i < kBalls; ++i) {
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

probe::RenderQuestion renderOf(Draw& draw, SceneDescription scene, const RenderSettings& settings,
                               int repetitions) {
    probe::RenderQuestion question;
    question.scene = std::move(scene);
    question.settings = settings;
    question.settings.seed = draw.word() >> 1U;
    question.repetitions = repetitions;
    const auto rays = static_cast<std::size_t>(settings.width * settings.height * repetitions) *
                      static_cast<std::size_t>(settings.dofRayCount);
    question.eventCapacity = static_cast<std::uint32_t>(rays * kEventsForEachRay);
    return question;
}

std::vector<probe::RenderQuestion> drawMixedRenders(std::uint64_t seed) {
    Draw draw{seed, 30};
    RenderSettings near;
    near.width = 4;
    near.height = 3;
    RenderSettings far = near;
    near.dofFocalPlane = draw.between(0.6, 0.8);
    near.dofAmount = draw.between(0.28, 0.32);
    far.dofFocalPlane = draw.between(25.0, 40.0);
    far.dofAmount = draw.between(0.02, 0.04);
    std::vector<probe::RenderQuestion> renders;
    for (const RenderSettings& settings : {near, far})
        renders.push_back(renderOf(draw, drawBalls(draw), settings));

    Deck<Shows> shows{draw,
                      {Shows::usual, Shows::nothing, Shows::black, Shows::dark, Shows::bright,
                       Shows::mirrors, Shows::close}};
    Deck<Size> sizes{draw, {{1, 1}, {1, 4}, {5, 1}, {3, 5}, {7, 2}, {2, 2}, {4, 3}}};
    Deck<Between> focalPlane{draw, {{0.6, 0.9}, {1.5, 2.5}, {4.0, 8.0}, {25.0, 40.0}}};
    Deck<Between> amount{draw, {{0.02, 0.04}, {0.2, 0.2}, {0.28, 0.32}, {0.6, 0.8}}};
    Deck<int> bounces{draw, {0, 1, 2, 6}};
    for (int i = 0; i < kRenders; ++i) {
        const Size size = sizes.deal();
        RenderSettings settings;
        settings.width = size.width;
        settings.height = size.height;
        settings.dofFocalPlane = focalPlane.deal().number(draw);
        settings.dofAmount = amount.deal().number(draw);
        settings.bounces = bounces.deal();
        SceneDescription scene = drawScene(draw, shows.deal());
        renders.push_back(renderOf(draw, std::move(scene), settings));
    }
    renders.push_back(drawInFocus(seed));
    return renders;
}

std::string wordsOf(const probe::RenderQuestion& asked) {
    const RenderSettings& settings = asked.settings;
    const bool inFocus = showsFocalPlane(asked.scene, settings);
    return fmt::format(
        "in a picture of {} x {} pixels of {}, with the focal plane at {:.3g}, a dofAmount of "
        "{:.2g} and {} bounces",
        settings.width, settings.height,
        inFocus ? "a surface in the focal plane" : sceneWords(asked.scene), settings.dofFocalPlane,
        settings.dofAmount, settings.bounces);
}

}  // namespace ticker::tasks
