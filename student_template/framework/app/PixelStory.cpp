#include "PixelStory.h"

#include <raytracer/image/ToneCurve.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <map>

namespace raytracer {
namespace {

constexpr std::size_t kRaysInFull = 3;

std::string number(double value) {
    constexpr double kNothing =
        1e-9;  // smaller values, such as powers of small cosines, are invisible
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", std::abs(value) < kNothing ? 0.0 : value);
    return text.data();
}

std::string triple(double a, double b, double c) {
    return "(" + number(a) + ", " + number(b) + ", " + number(c) + ")";
}

std::string text(const Vector3& v) {
    return triple(v.x, v.y, v.z);
}

std::string text(const ColourRGB& colour) {
    return triple(colour.r, colour.g, colour.b);
}

std::string counted(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string hexOf(const ColourRGB& colour) {
    const std::array<std::uint8_t, 3> bytes = toneMapped(colour);
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "#%02X%02X%02X", bytes[0], bytes[1], bytes[2]);
    return text.data();
}

class Story {
public:
    explicit Story(const Scene& scene) : scene_(scene) {}

    void add(const std::string& line) { text_ += std::string(2 * depth_, ' ') + line + "\n"; }

    void add(const TracedRay& traced, const std::string& name) {
        add(name + " from " + text(traced.ray.origin) + " towards " + text(traced.ray.direction) +
            ", " + counted(static_cast<std::size_t>(traced.bouncesLeft), "bounce") + " left");
        ++depth_;
        if (traced.hit) {
            addHit(*traced.hit);
            addLights(traced);
            addReflection(traced);
        } else {
            add("meets nothing: background " + text(traced.colour));
        }
        --depth_;
    }

    void addShort(const TracedRay& traced, const std::string& name) {
        const std::string met = traced.hit ? nameOf(traced.hit->object) : "nothing";
        add(name + " from " + text(traced.ray.origin) + " meets " + met + ": " +
            text(traced.colour));
    }

    [[nodiscard]] const std::string& told() const { return text_; }

private:
    [[nodiscard]] std::string nameOf(const SceneObject* object) const {
        std::map<std::string, int> seen;
        for (const auto& candidate : scene_.objects()) {
            std::string kind = "sphere";
            if (dynamic_cast<const Plane*>(candidate.get()) != nullptr) kind = "plane";
            if (dynamic_cast<const BumpySphere*>(candidate.get()) != nullptr) kind = "bumpy sphere";
            const int place = ++seen[kind];
            if (candidate.get() == object) return kind + " " + std::to_string(place);
        }
        return "an object";
    }

    void addHit(const RaycastHit& hit) {
        add("meets " + nameOf(hit.object) + " at " + text(hit.location) + ", distance " +
            number(hit.distance) + ", normal " + text(hit.normal));
    }

    /// The light that a shadow ray most likely aims at: the one closest to its direction.
    [[nodiscard]] std::size_t aimOf(const Ray& ray) const {
        std::size_t best = 0;
        double most = -2.0;
        for (std::size_t i = 0; i < scene_.pointLights().size(); ++i) {
            const Vector3 towards = scene_.pointLights()[i].position() - ray.origin;
            const double cosine = towards.normalised().dot(ray.direction.normalised());
            if (cosine > most) {
                most = cosine;
                best = i;
            }
        }
        return best;
    }

    void addLights(const TracedRay& traced) {
        const SceneObject& object = *traced.hit->object;
        add("ambient light " + text(object.colour() * scene_.ambientLighting()));
        for (std::size_t i = 0; i < scene_.pointLights().size(); ++i)
            addLight(traced, i);
        if (traced.direct) add("illuminate gives " + text(*traced.direct));
    }

    void addLight(const TracedRay& traced, std::size_t index) {
        const PointLight& light = scene_.pointLights()[index];
        std::size_t cast = 0;
        std::map<std::string, std::size_t> stoppedBy;
        for (const SeenRay& seen : traced.shadowRays) {
            if (aimOf(seen.ray) != index) continue;
            ++cast;
            const double reach = (light.position() - seen.ray.origin).magnitude();
            if (seen.hit && seen.hit->distance * seen.ray.direction.magnitude() < reach)
                ++stoppedBy[nameOf(seen.hit->object)];
        }
        std::size_t stopped = 0;
        std::string by;
        for (const auto& [name, count] : stoppedBy) {
            stopped += count;
            by += ", " + std::to_string(count) + " stopped by " + name;
        }
        add("light " + std::to_string(index + 1) + ": " + counted(cast, "shadow ray") + ", " +
            std::to_string(cast - stopped) + " arrive" + by);
        addUnshadowed(traced, light);
    }

    void addUnshadowed(const TracedRay& traced, const PointLight& light) {
        const SceneObject& object = *traced.hit->object;
        const Vector3 path = light.position() - traced.hit->location;
        const Vector3 toLight = path.normalised();
        const Vector3 toViewer = -traced.ray.direction.normalised();
        const ColourRGB arriving = light.illuminationAt(path.magnitude());
        const double facing = std::max(0.0, traced.hit->normal.dot(toLight));
        const double mirrored = std::max(0.0, toLight.reflectIn(traced.hit->normal).dot(toViewer));
        const ColourRGB diffuse = object.colour() * arriving * (object.phongKD() * facing);
        const ColourRGB specular = light.colour() * arriving *
                                   (object.phongKS() * std::pow(mirrored, object.phongAlpha()));
        ++depth_;
        add("without any shadow: diffuse " + text(diffuse) + ", specular " + text(specular));
        --depth_;
    }

    void addReflection(const TracedRay& traced) {
        for (const TracedRay& reflected : traced.reflected)
            add(reflected, "reflected ray");
        if (!traced.reflected.empty())
            add("with " + number(traced.hit->object->reflectivity()) +
                " of the reflection: " + text(traced.colour));
    }

    const Scene& scene_;
    std::string text_;
    std::size_t depth_ = 0;
};

}  // namespace

std::string storyOf(const PixelLog& log, const Scene& scene, bool inFull) {
    Story story{scene};
    if (log.cameraRay())
        story.add("camera.castRay gives a ray towards " + text(log.cameraRay()->direction));
    const std::vector<TracedRay>& rays = log.traced();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const std::string name = "camera ray " + std::to_string(i + 1);
        if (inFull || i < kRaysInFull)
            story.add(rays[i], name);
        else
            story.addShort(rays[i], name);
    }
    if (rays.empty()) story.add("trace was never called");
    if (!log.loose().empty())
        story.add(counted(log.loose().size(), "ray") + " cast outside of trace and illuminate");
    if (log.pixel())
        story.add("the pixel becomes " + text(*log.pixel()) + ", in the file " +
                  hexOf(*log.pixel()));
    else
        story.add("the pixel was never set");
    if (!inFull && rays.size() > kRaysInFull) story.add("(--verbose tells of every ray in full)");
    return story.told();
}

}  // namespace raytracer
