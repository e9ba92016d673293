#include "PixelStory.h"

#include <raytracer/geometry/Plane.h>
#include <raytracer/image/ToneCurve.h>

#include <map>
#include <sstream>
#include <string>

namespace raytracer {
namespace {

std::string text(const Vector3& v) {
    std::ostringstream words;
    words << '(' << v.x << ", " << v.y << ", " << v.z << ')';
    return words.str();
}

std::string nameOf(const SceneObject* object, const Scene& scene) {
    std::map<std::string, int> seen;
    for (const auto& candidate : scene.objects()) {
        const bool isPlane = dynamic_cast<const Plane*>(candidate.get()) != nullptr;
        const std::string kind = isPlane ? "plane" : "sphere";
        const int place = ++seen[kind];
        if (candidate.get() == object) return kind + " " + std::to_string(place);
    }
    return "an object";
}

std::string storyOf(const SeenRay& seen, const Scene& scene) {
    std::ostringstream words;
    words << "ray from " << text(seen.ray.origin) << " towards " << text(seen.ray.direction);
    if (!seen.hit) return words.str() + " meets nothing\n";
    words << " meets " << nameOf(seen.hit->object, scene) << "\n  at " << text(seen.hit->location)
          << ", distance " << seen.hit->distance << ", normal " << text(seen.hit->normal) << '\n';
    return words.str();
}

}  // namespace

// Every ray in the order in which it was cast. The log does not contain which of them are shadow
// rays and which are mirrored.
std::string storyOf(const PixelLog& log, const Scene& scene, bool /*inFull*/) {
    std::string story;
    for (const SeenRay& seen : log.loose())
        story += storyOf(seen, scene);
    if (!log.pixel()) return story + "the pixel was never set\n";
    const ColourRGB& colour = *log.pixel();
    return story + "the pixel becomes " + text({colour.r, colour.g, colour.b}) + '\n';
}

}  // namespace raytracer
