// What the public tests ask. The grader asks the same kind of questions, about other scenes.
#include "PublicTests.h"

#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace raytracer::tests {
namespace {

std::string text(double a, double b, double c) {
    char words[80];
    std::snprintf(words, sizeof words, "(%.4g, %.4g, %.4g)", a, b, c);
    return words;
}
std::string text(const Vector3& v) {
    return text(v.x, v.y, v.z);
}
std::string text(const ColourRGB& c) {
    return text(c.r, c.g, c.b);
}

bool isNear(double a, double b) {
    return std::abs(a - b) <= 1e-3 * std::max(1.0, std::abs(b));
}
bool isNear(const Vector3& a, const Vector3& b) {
    return isNear(a.x, b.x) && isNear(a.y, b.y) && isNear(a.z, b.z);
}
bool isNear(const ColourRGB& a, const ColourRGB& b) {
    const double scale = std::max({b.r, b.g, b.b, 1e-3});
    return std::abs(a.r - b.r) <= 5e-3 * scale && std::abs(a.g - b.g) <= 5e-3 * scale &&
           std::abs(a.b - b.b) <= 5e-3 * scale;
}

/// What an object says of a ray; a distance of 0 stands for no hit.
Outcome askHit(const SceneDescription& scene, const Ray& ray, double distance,
               const Vector3& normal, const char* asked, const char* likely) {
    const Scene built{scene};
    const auto hit = built.objects().front()->intersectionWith(ray);
    Outcome outcome{asked, "no hit", "no hit", likely, false};
    const auto words = [&](double s, const Vector3& at, const Vector3& n) {
        return "a hit at distance " + std::to_string(s) + ", location " + text(at) + ", normal " +
               text(n);
    };
    if (distance > 0.0) outcome.expected = words(distance, ray.evaluateAt(distance), normal);
    if (hit) outcome.got = words(hit->distance, hit->location, hit->normal);
    outcome.isRight = distance > 0.0 ? hit && isNear(hit->distance, distance) &&
                                           isNear(hit->location, ray.evaluateAt(distance)) &&
                                           isNear(hit->normal, normal)
                                     : !hit;
    return outcome;
}

std::vector<Outcome> askSpheres() {
    SceneDescription scene;
    scene.spheres.push_back({{1.0, 0.0, 5.0}, 2.0, {}, nullptr});
    const Vector3 ahead{0.0, 0.0, 1.0};
    return {askHit(scene, {{1.0, 1.2, 0.0}, ahead}, 3.4, {0.0, 0.6, -0.8}, "a ray from outside",
                   "Of the two roots the smaller positive one is the hit; check a, b and c."),
            askHit(scene, {{1.0, 1.2, 9.0}, ahead}, 0.0, {}, "a ray with the sphere behind it",
                   "Negative distances lie behind the ray."),
            askHit(scene, {{1.0, 2.5, 0.0}, ahead}, 0.0, {}, "a ray that passes by",
                   "A negative discriminant means no hit."),
            askHit(scene, {{1.0, 0.0, 4.0}, ahead}, 3.0, {0.0, 0.0, 1.0}, "a ray from inside",
                   "From inside one root is negative; the other one is the hit. The normal points "
                   "away from the centre.")};
}

std::vector<Outcome> askPlanes() {
    SceneDescription scene;
    scene.planes.push_back({{0.0, -1.0, 0.0}, {0.0, 2.0, 0.0}, {}});
    const Vector3 down{0.0, -0.6, 0.8};
    const Vector3 up{0.0, 0.6, 0.8};
    return {askHit(scene, {{3.0, 2.0, 1.0}, down}, 5.0, {0.0, 1.0, 0.0}, "a ray from above",
                   "s = (Q - O).N / D.N"),
            askHit(scene, {{0.0, -4.0, 0.0}, up}, 5.0, {0.0, 1.0, 0.0}, "a ray from below",
                   "The sign of D.N alone says nothing: a positive s is a hit, from either side."),
            askHit(scene, {{0.0, 2.0, 0.0}, up}, 0.0, {}, "a ray that leaves the plane behind",
                   "A negative s lies behind the ray.")};
}

/// A floor at y = 0 with a light above it, and what the scene of a question adds.
SceneDescription room() {
    SceneDescription scene;
    scene.ambientLighting = {0.1, 0.2, 0.3};
    Material floor;
    floor.colour = {0.5, 0.25, 1.0};
    floor.reflectivity = 0.5;
    scene.planes.push_back({{}, {0.0, 1.0, 0.0}, floor});
    return scene;
}

void addLight(SceneDescription& scene, const Vector3& at) {
    scene.pointLights.emplace_back(at, ColourRGB{1.0, 0.5, 0.25}, 100.0);
}

Outcome askLight(const SceneDescription& scene, const ColourRGB& expected, const char* asked,
                 const char* likely) {
    const Scene built{scene};
    const ColourRGB got = Renderer{RenderSettings{}}.illuminate(
        built, *built.objects().back(), {1.0, 0.0, 4.0}, {0.0, 1.0, 0.0}, {-0.5, 2.0, 4.5});
    return {asked, text(expected), text(got), likely, isNear(got, expected)};
}

std::vector<Outcome> askPhong() {
    SceneDescription dark = room();
    SceneDescription one = room();
    addLight(one, {2.0, 2.0, 4.0});
    SceneDescription dull = one;
    dull.planes[0].material.phongKS = 0.0;
    SceneDescription two = one;
    addLight(two, {0.0, 3.0, 2.0});
    return {askLight(dark, {0.05, 0.05, 0.3}, "a point without any point light",
                     "Ambient light: object.colour() * scene.ambientLighting()."),
            askLight(dull, {0.61941, 0.192353, 0.584705}, "a dull point (ks = 0) in the light",
                     "The diffuse term: max(0, N.L), with N and L of length 1, and kd."),
            askLight(one, {1.95358, 0.525895, 0.668091}, "a glossy point in the light",
                     "The specular term: max(0, R.V) to the power alpha, V from P to O, and the "
                     "colour of the light twice."),
            askLight(two, {2.13865, 0.572162, 0.759412}, "a glossy point in the light of two lamps",
                     "Add the terms of every light.")};
}

std::vector<Outcome> askShadows() {
    SceneDescription lit = room();
    addLight(lit, {2.0, 2.0, 4.0});
    SceneDescription hidden = lit;
    hidden.spheres.push_back({{1.5, 1.0, 4.0}, 0.3, {}, nullptr});
    SceneDescription beyond = lit;
    beyond.spheres.push_back({{3.0, 4.0, 4.0}, 0.5, {}, nullptr});
    const ColourRGB light{1.95358, 0.525895, 0.668091};
    return {askLight(hidden, {0.05, 0.05, 0.3}, "a point with a ball before the light",
                     "Cast a ray from P + N * kShadowBias towards the light; ambient light stays."),
            askLight(beyond, light, "a point with a ball behind the light",
                     "Only a hit that is nearer than the light shades."),
            askLight(lit, light, "a point with nothing but its own surface",
                     "The ray must start a little above the surface.")};
}

Outcome askTrace(const SceneDescription& scene, const Ray& ray, int bounces,
                 const ColourRGB& expected, const char* asked, const char* likely) {
    const Scene built{scene};
    const ColourRGB got = Renderer{RenderSettings{}}.trace(built, ray, bounces);
    return {asked, text(expected), text(got), likely, isNear(got, expected)};
}

std::vector<Outcome> askReflections() {
    SceneDescription scene = room();
    Material wall;
    wall.colour = {0.0, 1.0, 0.0};
    wall.reflectivity = 0.5;
    scene.planes.push_back({{0.0, 0.0, 6.0}, {0.0, 0.0, -1.0}, wall});
    const Ray ray{{0.0, 3.0, 0.0}, {0.0, -0.6, 0.8}};
    const Ray sky{{0.0, 3.0, 0.0}, {0.0, 0.6, -0.8}};
    // The stub is reached where something is hit.
    SceneDescription ball = room();
    ball.spheres.push_back({{0.0, 0.0, 5.0}, 1.0, {}, nullptr});
    static_cast<void>(askTrace(ball, {{}, {0.0, 0.0, 1.0}}, 1, {}, "", ""));
    const char* blend = "direct * (1 - rho) + reflected * rho, with rho = object.reflectivity()";
    return {askTrace(scene, ray, 0, {0.05, 0.05, 0.3}, "a mirror without bounces left",
                     "Without bounces left the direct light counts whole."),
            askTrace(scene, ray, 1, {0.025, 0.125, 0.15}, "a mirror with one bounce left", blend),
            askTrace(scene, ray, 2, {0.02525, 0.07525, 0.15025}, "a mirror in a mirror",
                     "Hand bouncesLeft - 1 on; a mirrored ray that meets nothing shows the "
                     "background."),
            askTrace(scene, sky, 2, kBackgroundColour, "a ray that meets nothing",
                     "Return kBackgroundColour.")};
}

}  // namespace

std::vector<Suite> suites() {
    return {{"M1", "spheres", askSpheres, {}},
            {"M2", "Phong illumination", askPhong, {}},
            {"M3.1", "planes", askPlanes, {}},
            {"M3.2", "shadows", askShadows, {"M1", "M2"}},
            {"M4", "reflections", askReflections, {"M2", "M3.1"}}};
}

}  // namespace raytracer::tests
