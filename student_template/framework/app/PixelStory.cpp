#include "PixelStory.h"

#include "SceneWords.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

namespace raytracer {
namespace {

constexpr std::size_t kRaysInFull = 3;

class Story {
public:
    explicit Story(const Scene& scene) : scene_(scene) {}

    void add(const std::string& line) { text_ += std::string(2 * depth_, ' ') + line + "\n"; }

    void add(const TracedRay& traced, const std::string& name) {
        add(name + " from " + tripleText(traced.ray.origin) + " towards " +
            tripleText(traced.ray.direction) + ", " +
            countedText(static_cast<std::size_t>(traced.bouncesLeft), "bounce") + " left");
        ++depth_;
        if (traced.hit) {
            addHit(*traced.hit);
            addLights(traced);
            addReflection(traced);
        } else {
            add("meets nothing: background " + tripleText(traced.colour));
        }
        --depth_;
    }

    void addShort(const TracedRay& traced, const std::string& name) {
        const std::string met = traced.hit ? nameOf(scene_, traced.hit->object) : "nothing";
        add(name + " from " + tripleText(traced.ray.origin) + " meets " + met + ": " +
            tripleText(traced.colour));
    }

    [[nodiscard]] const std::string& told() const { return text_; }

private:
    void addHit(const RaycastHit& hit) {
        add("meets " + nameOf(scene_, hit.object) + " at " + tripleText(hit.location) +
            ", distance " + numberText(hit.distance) + ", normal " + tripleText(hit.normal));
    }

    void addLights(const TracedRay& traced) {
        const SceneObject& object = *traced.hit->object;
        add("ambient light " + tripleText(object.colour() * scene_.ambientLighting()));
        for (std::size_t i = 0; i < scene_.pointLights().size(); ++i)
            addLight(traced, i);
        if (traced.direct) add("illuminate gives " + tripleText(*traced.direct));
    }

    void addLight(const TracedRay& traced, std::size_t index) {
        const PointLight& light = scene_.pointLights()[index];
        std::size_t cast = 0;
        std::map<std::string, std::size_t> stoppedBy;
        for (const SeenRay& seen : traced.shadowRays) {
            if (aimOf(scene_, seen.ray) != index) continue;
            ++cast;
            if (isStopped(seen, light)) ++stoppedBy[nameOf(scene_, seen.hit->object)];
        }
        std::size_t stopped = 0;
        std::string by;
        for (const auto& [name, count] : stoppedBy) {
            stopped += count;
            by += ", " + std::to_string(count) + " stopped by " + name;
        }
        add("light " + std::to_string(index + 1) + ": " + countedText(cast, "shadow ray") + ", " +
            arrivingText(cast - stopped) + by);
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
        add("without any shadow: diffuse " + tripleText(diffuse) + ", specular " +
            tripleText(specular));
        --depth_;
    }

    void addReflection(const TracedRay& traced) {
        for (const TracedRay& reflected : traced.reflected)
            add(reflected, "reflected ray");
        if (!traced.reflected.empty())
            add("with " + numberText(traced.hit->object->reflectivity()) +
                " of the reflection: " + tripleText(traced.colour));
    }

    const Scene& scene_;
    std::string text_;
    std::size_t depth_ = 0;
};

}  // namespace

std::string storyOf(const PixelLog& log, const Scene& scene, bool inFull) {
    Story story{scene};
    if (log.cameraRay())
        story.add("camera.castRay gives a ray towards " + tripleText(log.cameraRay()->direction));
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
        story.add(countedText(log.loose().size(), "ray") + " cast outside of trace and illuminate");
    if (log.pixel())
        story.add("the pixel becomes " + tripleText(*log.pixel()) + ", in the file " +
                  hexOf(*log.pixel()));
    else
        story.add("the pixel was never set");
    if (!inFull && rays.size() > kRaysInFull) story.add("(--verbose tells of every ray in full)");
    return story.told();
}

}  // namespace raytracer
