#include <grader/tasks/shadows/mixed/PointQueries.h>
#include <grader/tasks/shadows/mixed/ShadowTraits.h>
#include <grader/tasks/support/Channels.h>

#include <array>
#include <cstddef>

namespace ticker::tasks {
namespace {

using raytracer::Material;
using raytracer::PointLight;

constexpr const char* kAnyObject =
    "Whatever stands in the way hides the light: do not ask what kind of object it is, nor of what "
    "material.";
constexpr const char* kEveryLight =
    "The falloff is one over the square of the distance, near and far, and every light counts, "
    "however little it adds: leave out limits of your own.";
constexpr const char* kSurface =
    "Colour, ambient light, diffuse and specular term are computed for every material in the same "
    "way, and each term stays whatever the others are.";
constexpr const char* kPlace =
    "P, N and O are all that tells where the point lies and where it is seen from: do not ask on "
    "which side of the camera they are.";

constexpr std::array kTraits{
    PointTrait{"there is no point light",
               [](const PointOfLog& at) { return at.log->scene().pointLights.empty(); },
               "The ambient light is added before the loop over the lights, and is there without "
               "any light, too."},
    PointTrait{"a light is nearer than 1",
               [](const PointOfLog& at) {
                   return anyLight(at, [&](const PointLight& light) {
                       return isInFront(at, light) && distanceOf(at, light) < 1.0;
                   });
               },
               kEveryLight},
    PointTrait{"a light is nearer than 0.5",
               [](const PointOfLog& at) {
                   return anyLight(at, [&](const PointLight& light) {
                       return isInFront(at, light) && distanceOf(at, light) < 0.5;
                   });
               },
               kEveryLight},
    PointTrait{"a light is farther away than 19",
               [](const PointOfLog& at) {
                   return anyLight(at, [&](const PointLight& light) {
                       return isInFront(at, light) && distanceOf(at, light) > 19.0;
                   });
               },
               kEveryLight},
    PointTrait{"a light is farther away than 1000",
               [](const PointOfLog& at) {
                   return anyLight(at, [&](const PointLight& light) {
                       return isInFront(at, light) && distanceOf(at, light) > 1000.0;
                   });
               },
               kEveryLight},
    PointTrait{"a light adds less than one step of a picture",
               [](const PointOfLog& at) {
                   return anyLight(at, [&](const PointLight& light) {
                       return isInFront(at, light) &&
                              largestChannel(light.illuminationAt(distanceOf(at, light))) <
                                  1.0 / 255.0;
                   });
               },
               kEveryLight},
    PointTrait{"a light is very bright",
               [](const PointOfLog& at) {
                   return anyLight(at, [&](const PointLight& light) {
                       return largestChannel(light.illuminationAt(distanceOf(at, light))) > 3.0;
                   });
               },
               "Colours may be above 1: do not cut them off."},
    PointTrait{"a light has one channel alone",
               [](const PointOfLog& at) {
                   return anyLight(
                       at, [](const PointLight& light) { return channelsOf(light.colour()) == 1; });
               },
               kEveryLight},
    PointTrait{"a light is behind the surface",
               [](const PointOfLog& at) {
                   return anyLight(at, [&](const PointLight& l) { return !isInFront(at, l); });
               },
               "A light behind the surface adds nothing and changes nothing of the others: go on "
               "with the next one (continue)."},
    PointTrait{"there are more than 12 lights",
               [](const PointOfLog& at) { return at.log->scene().pointLights.size() > 12; },
               "Every light of the scene counts, however many there are: loop over "
               "scene.pointLights() to its end, without a table of a fixed size."},
    PointTrait{"there are several lights",
               [](const PointOfLog& at) { return at.log->scene().pointLights.size() > 1; },
               "Each light has rays and a share of its own: start again at 0 for each of them."},
    PointTrait{"a bumpy sphere is in the light's way",
               [](const PointOfLog& at) {
                   return anyBlockerThat(at, [](const raytracer::SceneDescription& of, int i) {
                       return sphereOf(of, i) != nullptr && sphereOf(of, i)->heightMap != nullptr;
                   });
               },
               kAnyObject},
    PointTrait{"a ball whose centre is farther away than 19 is in the light's way",
               [](const PointOfLog& at) {
                   return anyBlockerThat(at, [&](const raytracer::SceneDescription& of, int i) {
                       constexpr double kFar = 19.0;
                       const auto* ball = sphereOf(of, i);
                       const Vector3& point = at.point->point.position;
                       return ball != nullptr && (ball->centre - point).magnitude() > kFar;
                   });
               },
               kAnyObject},
    PointTrait{"a ball that is farther away than 900 is in the light's way",
               [](const PointOfLog& at) {
                   return anyBlockerThat(at, [&](const raytracer::SceneDescription& of, int i) {
                       constexpr double kVeryFar = 900.0;
                       const auto* ball = sphereOf(of, i);
                       const Vector3& point = at.point->point.position;
                       return ball != nullptr &&
                              (ball->centre - point).magnitude() - ball->radius > kVeryFar;
                   });
               },
               kAnyObject},
    PointTrait{"an object of reflectivity 1 is in the light's way",
               [](const PointOfLog& at) {
                   return anyBlocker(at, [](const Material& of) { return of.reflectivity == 1.0; });
               },
               kAnyObject},
    PointTrait{"an object that does not reflect is in the light's way",
               [](const PointOfLog& at) {
                   return anyBlocker(at, [](const Material& of) { return of.reflectivity == 0.0; });
               },
               kAnyObject},
    PointTrait{"a black object is in the light's way",
               [](const PointOfLog& at) {
                   return anyBlocker(at,
                                     [](const Material& of) { return channelsOf(of.colour) == 0; });
               },
               kAnyObject},
    PointTrait{"an object is in the light's way, less than 0.05 before the light",
               [](const PointOfLog& at) { return anyBlockerWithin(at, 0.05); },
               "A hit before the light's place hides it, however close to the light: compare the "
               "distances as they are, and take nothing from them."},
    PointTrait{
        "an object is in the light's way",
        [](const PointOfLog& at) { return anyBlocker(at, [](const Material&) { return true; }); },
        kAnyObject},
    PointTrait{"the surface is black",
               [](const PointOfLog& at) { return channelsOf(surfaceOf(at).colour) == 0; },
               kSurface},
    PointTrait{"the surface's colour lacks a channel",
               [](const PointOfLog& at) { return channelsOf(surfaceOf(at).colour) < 3; }, kSurface},
    PointTrait{"the surface's phongKD() is 0",
               [](const PointOfLog& at) { return surfaceOf(at).phongKD == 0.0; }, kSurface},
    PointTrait{"the surface's phongKD() is above 1",
               [](const PointOfLog& at) { return surfaceOf(at).phongKD > 1.0; }, kSurface},
    PointTrait{"the surface's phongKS() is 0",
               [](const PointOfLog& at) { return surfaceOf(at).phongKS == 0.0; }, kSurface},
    PointTrait{"the surface's phongAlpha() is 1",
               [](const PointOfLog& at) { return surfaceOf(at).phongAlpha == 1.0; }, kSurface},
    PointTrait{"the surface's phongAlpha() is 30 or more",
               [](const PointOfLog& at) { return surfaceOf(at).phongAlpha >= 30.0; }, kSurface},
    PointTrait{"the surface's phongAlpha() is above 100",
               [](const PointOfLog& at) { return surfaceOf(at).phongAlpha > 100.0; }, kSurface},
    PointTrait{"the surface's reflectivity() is 1",
               [](const PointOfLog& at) { return surfaceOf(at).reflectivity == 1.0; },
               "illuminate knows nothing of mirrors: leave reflectivity() out of it."},
    PointTrait{"the surface's reflectivity() is 0",
               [](const PointOfLog& at) { return surfaceOf(at).reflectivity == 0.0; },
               "illuminate knows nothing of mirrors: leave reflectivity() out of it."},
    PointTrait{
        "there is no ambient light",
        [](const PointOfLog& at) { return largestChannel(at.log->scene().ambientLighting) == 0.0; },
        kSurface},
    PointTrait{"the point lies behind the camera",
               [](const PointOfLog& at) { return at.point->point.position.z < 0.0; }, kPlace},
    PointTrait{"O is behind the camera",
               [](const PointOfLog& at) { return at.point->point.viewer.z < -0.01; }, kPlace},
    PointTrait{"O is not on the lens",
               [](const PointOfLog& at) { return at.point->point.viewer.z != 0.0; }, kPlace},
    PointTrait{"O is on the lens",
               [](const PointOfLog& at) { return at.point->point.viewer.z == 0.0; }, kPlace},
    PointTrait{"the point lies on a sphere",
               [](const PointOfLog& at) {
                   return static_cast<std::size_t>(at.point->point.object) <
                          at.log->scene().spheres.size();
               },
               ""},
    PointTrait{"the point lies on a plane",
               [](const PointOfLog& at) {
                   return static_cast<std::size_t>(at.point->point.object) >=
                          at.log->scene().spheres.size();
               },
               ""}};

}  // namespace

std::span<const PointTrait> pointTraits() {
    return kTraits;
}

}  // namespace ticker::tasks
