#include <questions/RayGeometry.h>
#include <raytracer/base/Unfinished.h>
#include <raytracer/math/Random.h>
#include <raytracer/render/Renderer.h>
#include <shadows/Room.h>
#include <shadows/SoftShadows.h>
#include <support/Complaint.h>
#include <support/KeptScene.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace raytracer::tests::shadows {

std::string words(const ColourRGB& c) {
    return "(" + inWords(c.r) + ", " + inWords(c.g) + ", " + inWords(c.b) + ")";
}

bool isNear(const ColourRGB& a, const ColourRGB& b, double share) {
    const auto near = [share](double x, double y) {
        return std::abs(x - y) <= share * std::max(std::abs(x), std::abs(y)) + 1e-9;
    };
    return near(a.r, b.r) && near(a.g, b.g) && near(a.b, b.b);
}

Trial::Trial(const SceneDescription& description, const Vector3& point, int calls, int object) {
    const Scene& scene = keptScene(description, &log_);
    RenderSettings settings;
    settings.observer = &log_;
    const Renderer renderer{settings};
    const auto& objects = scene.objects();
    const SceneObject& hit =
        object < 0 ? *objects.back() : *objects[static_cast<std::size_t>(object)];
    const Vector3 normal = hit.getNormalAt(point);
    for (int i = 0; i < calls; ++i) {
        seedRandom(1000U + static_cast<unsigned>(i));
        log_.clear();
        // Never exactly the same point: a solution may seed a generator from it.
        const Vector3 moved = point + Vector3{1e-7 * i, 0.0, 3e-7 * i};
        const ColourRGB colour = renderer.illuminate(scene, hit, moved, normal, kEye);
        colours_.push_back(colour);
        mean_ += colour / calls;
        fewestRays_ = std::min(fewestRays_, log_.rays().size());
        for (const Ray& ray : log_.rays())
            rays_.push_back(questions::seenFrom(moved, normal, ray));
    }
}

void SoftShadows::SetUp() {
    static_cast<void>(Trial{emptyRoom(), floorAt(1.0), 1});
    if (isUnfinished("T2.1"))
        GTEST_SKIP() << "T2.1 is not attempted: the line unfinished(\"T2.1\", ...) still stands";
}

bool SoftShadows::lacksRays(const Trial& trial) {
    if (trial.rays().empty()) return true;
    const Trial edge{roomWithBall(), floorWhereLightIsClearBy(0.0), 40};
    const bool central = std::all_of(edge.rays().begin(), edge.rays().end(), [](const Ray& ray) {
        return questions::footFrom(kLight, ray).magnitude() < 1e-3;
    });
    const bool same = std::all_of(
        edge.colours().begin(), edge.colours().end(),
        [&](const ColourRGB& colour) { return isNear(colour, edge.colours().front(), 1e-3); });
    return central && !same;
}

}  // namespace raytracer::tests::shadows
