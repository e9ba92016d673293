#include "DrawingJson.h"

#include "../SceneWords.h"
#include "Json.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string_view>
#include <vector>

namespace raytracer::view {
namespace {

constexpr int kNone = -1;
// Arrows of more hits than these would hide the rest.
constexpr std::size_t kMostNormals = 4;
// How far a ray is drawn that meets nothing, world units.
constexpr double kReach = 4.0;

/// Collects the parts of one drawing.
class Drawing {
public:
    Drawing(const Scene& scene, const RenderSettings& settings)
        : scene_(scene), settings_(settings) {}

    void say(const std::string& words) { words_.add(json(words)); }

    /// @param before  Index of the ray that led to this one.
    int addRay(std::string_view kind, const Vector3& from, const Vector3& to,
               const std::string& words, int before, int light = kNone, bool missed = false) {
        Members ray;
        ray.add("k", json(kind)).add("a", json(from)).add("b", json(to)).add("t", json(words));
        ray.add("p", std::to_string(before)).add("l", std::to_string(light));
        if (missed) ray.add("m", "true");
        rays_.add(ray.object());
        return rayCount_++;
    }

    void addTraced(const TracedRay& traced, std::string_view kind, const std::string& name,
                   int before) {
        const Ray& ray = traced.ray;
        if (!traced.hit) {
            const Vector3 to = ray.origin + ray.direction.normalised() * kReach;
            addRay(kind, ray.origin, to, name + " meets nothing", before, kNone, true);
            return;
        }
        const int index =
            addRay(kind, ray.origin, traced.hit->location,
                   name + " meets " + nameOf(scene_, traced.hit->object) + " at " +
                       tripleText(traced.hit->location) + ": " + tripleText(traced.colour),
                   before);
        addNormal(*traced.hit);
        addShadowRays(traced.shadowRays, index);
        for (const TracedRay& reflected : traced.reflected)
            addTraced(reflected, "reflected", "reflected ray", index);
    }

    void addShadowRays(const std::vector<SeenRay>& seen, int before) {
        for (const SeenRay& ray : seen)
            addShadowRay(ray, before);
        if (!told_ && !seen.empty()) tellOfLights(seen);
    }

    void addLoose(const SeenRay& seen) {
        const Vector3 to = seen.hit ? seen.hit->location : endOf(seen.ray, kReach);
        const std::string met = seen.hit ? nameOf(scene_, seen.hit->object) : "nothing";
        addRay("other", seen.ray.origin, to,
               "ray " + std::to_string(++looseCount_) + " meets " + met, kNone, kNone, !seen.hit);
    }

    void addNormal(const RaycastHit& hit) {
        if (normalCount_++ >= kMostNormals) return;
        const auto* bumpy = dynamic_cast<const BumpySphere*>(hit.object);
        Members normal;
        normal.add("at", json(hit.location));
        if (bumpy != nullptr)
            normal.add("smooth", json((hit.location - bumpy->centre()).normalised()));
        normal.add("given", json(hit.normal));
        normals_.add(normal.object());
    }

    [[nodiscard]] std::string whole(const std::string& about) const {
        Members all;
        all.add("about", json(about)).add("words", words_.array());
        addScene(all);
        all.add("rays", rays_.array()).add("normals", normals_.array());
        return all.object();
    }

private:
    static Vector3 endOf(const Ray& ray, double distance) {
        return ray.origin + ray.direction.normalised() * distance;
    }

    void addShadowRay(const SeenRay& seen, int before) {
        if (scene_.pointLights().empty()) return addLoose(seen);
        const std::size_t aim = aimOf(scene_, seen.ray);
        const PointLight& light = scene_.pointLights()[aim];
        const std::string name = "shadow ray to light " + std::to_string(aim + 1);
        if (isStopped(seen, light)) {
            addRay("blocked", seen.ray.origin, seen.hit->location,
                   name + " is blocked by " + nameOf(scene_, seen.hit->object), before,
                   static_cast<int>(aim));
            return;
        }
        // Up to the plane through the light's centre that faces the start.
        const Vector3 towards = light.position() - seen.ray.origin;
        const double cosine = towards.normalised().dot(seen.ray.direction.normalised());
        const double reach = cosine > 0.1 ? towards.magnitude() / cosine : towards.magnitude();
        addRay("arrives", seen.ray.origin, endOf(seen.ray, reach), name + " arrives", before,
               static_cast<int>(aim));
    }

    /// Once: how many shadow rays of the first point arrive.
    void tellOfLights(const std::vector<SeenRay>& seen) {
        told_ = true;
        for (std::size_t i = 0; i < scene_.pointLights().size(); ++i) {
            std::size_t cast = 0;
            std::map<std::string, std::size_t> stoppedBy;
            for (const SeenRay& ray : seen) {
                if (aimOf(scene_, ray.ray) != i) continue;
                ++cast;
                if (isStopped(ray, scene_.pointLights()[i]))
                    ++stoppedBy[nameOf(scene_, ray.hit->object)];
            }
            std::size_t arrive = cast;
            std::string by;
            for (const auto& [name, count] : stoppedBy) {
                arrive -= count;
                by += ", " + std::to_string(count) + " blocked by " + name;
            }
            say("Light " + std::to_string(i + 1) + " from the first point: " +
                countedText(cast, "shadow ray") + ", " + arrivingText(arrive) + by + ".");
        }
    }

    void addScene(Members& all) const {
        Items spheres;
        Items planes;
        for (const auto& object : scene_.objects()) {
            Members shape;
            shape.add("name", json(nameOf(scene_, object.get())));
            shape.add("colour", json(object->colour()));
            if (const auto* sphere = dynamic_cast<const Sphere*>(object.get()))
                spheres.add(shape.add("centre", json(sphere->centre()))
                                .add("radius", json(sphere->radius()))
                                .object());
            else if (const auto* plane = dynamic_cast<const Plane*>(object.get()))
                planes.add(shape.add("point", json(plane->point()))
                               .add("normal", json(plane->normal()))
                               .object());
        }
        all.add("spheres", spheres.array()).add("planes", planes.array());
        addLights(all);
    }

    void addLights(Members& all) const {
        Items lights;
        for (std::size_t i = 0; i < scene_.pointLights().size(); ++i)
            lights.add(Members{}
                           .add("name", json("light " + std::to_string(i + 1)))
                           .add("centre", json(scene_.pointLights()[i].position()))
                           .add("radius", json(settings_.lightSize))
                           .object());
        all.add("lights", lights.array());
        all.add("lens", Members{}.add("halfWidth", json(settings_.dofAmount)).object());
        if (settings_.dofAmount > 0.0) all.add("focalPlane", json(settings_.dofFocalPlane));
    }

    const Scene& scene_;
    const RenderSettings& settings_;
    Items words_;
    Items rays_;
    Items normals_;
    int rayCount_ = 0;
    std::size_t normalCount_ = 0;
    std::size_t looseCount_ = 0;
    bool told_ = false;
};

/// "they start at x from -0.2 to 0.2 and y from -0.2 to 0.2"
std::string startsOf(const std::vector<TracedRay>& rays) {
    const auto between = [&](double Vector3::*axis) {
        const auto [low, high] = std::minmax_element(
            rays.begin(), rays.end(), [axis](const TracedRay& first, const TracedRay& second) {
                return first.ray.origin.*axis < second.ray.origin.*axis;
            });
        return "from " + numberText(low->ray.origin.*axis) + " to " +
               numberText(high->ray.origin.*axis);
    };
    return "they start at x " + between(&Vector3::x) + " and y " + between(&Vector3::y);
}

}  // namespace

std::string drawingOfPixel(const PixelLog& log, const Scene& scene, const RenderSettings& settings,
                           const Pixel& pixel) {
    Drawing drawing{scene, settings};
    const std::string name =
        "Pixel (" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) + ")";
    drawing.say(log.pixel() ? name + " becomes " + tripleText(*log.pixel()) + ", in the picture " +
                                  hexOf(*log.pixel()) + "."
                            : name + " was never set.");
    const std::vector<TracedRay>& rays = log.traced();
    drawing.say(rays.empty()
                    ? "No camera ray of trace was seen; rays are numbered as they were cast."
                    : countedText(rays.size(), "camera ray") +
                          (rays.size() > 1 ? "; " + startsOf(rays) : "") + ".");
    for (std::size_t i = 0; i < rays.size(); ++i)
        drawing.addTraced(rays[i], "camera", "camera ray " + std::to_string(i + 1), kNone);
    if (!rays.empty() && !log.loose().empty())
        drawing.say(countedText(log.loose().size(), "ray") +
                    " cast outside of trace and illuminate.");
    for (const SeenRay& seen : log.loose())
        drawing.addLoose(seen);
    return drawing.whole(name + " of " + std::to_string(settings.width) + " x " +
                         std::to_string(settings.height));
}

std::string drawingOfPoint(const PixelLog& log, const Scene& scene, const RenderSettings& settings,
                           const RaycastHit& point, const ColourRGB& colour) {
    Drawing drawing{scene, settings};
    const std::string name =
        "The point " + tripleText(point.location) + " of " + nameOf(scene, point.object);
    drawing.say(name + ": illuminate gives " + tripleText(colour) + " towards the eye.");
    drawing.addNormal(point);
    drawing.addShadowRays(log.loose(), kNone);
    return drawing.whole(name);
}

}  // namespace raytracer::view
