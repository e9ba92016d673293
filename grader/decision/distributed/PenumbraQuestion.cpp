#include <grader/decision/distributed/Draw.h>
#include <grader/decision/distributed/PenumbraQuestion.h>
#include <grader/decision/distributed/ShadowQuestions.h>

#include <cmath>

namespace ticker::decision {
namespace {

using Place = PenumbraQuestion::Place;

constexpr std::size_t kPoints = 12;
constexpr std::size_t kCalls = 2000;
constexpr std::size_t kRimPoints = 3;
constexpr std::size_t kRimCalls = 1000;

// In light sizes. A shadow bias of 1e-3 changes what a point sees by less than 0.001 of them, since
// the occluder stands seven times as far from the floor as from the light.
constexpr double kBeyondLow = 1.03;
constexpr double kBeyondHigh = 1.08;
constexpr double kWithinLow = 0.82;
constexpr double kWithinHigh = 0.88;

// The radius of the largest ball around the light that the sphere hides from the point.
double hiddenRadius(const raytracer::SceneDescription& scene, const Vector3& point) {
    const raytracer::SphereDescription& sphere = scene.spheres.front();
    const Vector3 toSphere = sphere.centre - point;
    const Vector3 toLight = scene.pointLights.front().position() - point;
    const double between = std::acos(toSphere.normalised().dot(toLight.normalised()));
    const double covered = std::asin(sphere.radius / toSphere.magnitude());
    return toLight.magnitude() * std::sin(covered - between);
}

class Writer {
public:
    Writer(PenumbraQuestion& drawn, Draw& draw) : drawn_(drawn), draw_(draw) {}

    void add(Place::Kind kind, const probe::LitPoint& point, std::size_t calls) {
        constexpr double kNowhere = 1e-6;
        const Perpendiculars sides = perpendicularsOf(point.normal);
        const bool fromLens = point.viewer.z == 0.0;
        drawn_.places.push_back({kind, fromLens, drawn_.question.points.size(), calls});
        for (std::size_t i = 0; i < calls; ++i) {
            probe::LitPoint moved = point;
            moved.position += sides.first * draw_.between(-kNowhere, kNowhere) +
                              sides.second * draw_.between(-kNowhere, kNowhere);
            drawn_.question.points.push_back(moved);
        }
    }

private:
    PenumbraQuestion& drawn_;
    Draw& draw_;
};

// Points of the floor next to `like`, at random around the shadow's middle.
void addRimPoints(Writer& writer, Draw& draw, const raytracer::SceneDescription& scene,
                  const probe::LitPoint& like) {
    const raytracer::SphereDescription& sphere = scene.spheres.front();
    const Vector3 light = scene.pointLights.front().position();
    const double size = raytracer::RenderSettings{}.lightSize;
    const Vector3 axis = (sphere.centre - light).normalised();
    const double rim = std::asin(sphere.radius / (sphere.centre - light).magnitude());
    std::size_t beyond = 0;
    std::size_t within = 0;
    for (int attempt = 0; attempt < 20000 && beyond + within < 2 * kRimPoints; ++attempt) {
        const Vector3 ray = draw.directionAround(axis, rim);
        probe::LitPoint point = like;
        point.position =
            light + ray * ((like.position - light).dot(like.normal) / ray.dot(like.normal));
        const double hidden = hiddenRadius(scene, point.position) / size;
        const bool isBeyond = hidden > kBeyondLow && hidden < kBeyondHigh;
        const bool isWithin = hidden > kWithinLow && hidden < kWithinHigh;
        if (isBeyond && beyond < kRimPoints) {
            writer.add(Place::Kind::beyondRim, point, kRimCalls);
            ++beyond;
        } else if (isWithin && within < kRimPoints) {
            writer.add(Place::Kind::withinRim, point, kRimCalls);
            ++within;
        }
    }
}

}  // namespace

PenumbraQuestion drawPenumbraQuestion(std::uint64_t seed) {
    // Questions of the exact layer's kind. The last one has the occluder next to the light.
    const std::uint64_t own = seed ^ 0x50454E554D425241U;
    PenumbraQuestion drawn;
    Draw draw{own, 24};
    Writer writer{drawn, draw};
    const std::vector<ShadowQuestion> all = drawShadowQuestions(own);
    const ShadowQuestion& near = all[1];
    drawn.question.scene = near.question.scene;
    drawn.question.settings = near.question.settings;
    for (std::size_t i = 0; i < near.zones.size() && drawn.places.size() < kPoints; ++i)
        if (near.zones[i][0] == Zone::penumbra)
            writer.add(Place::Kind::penumbra, near.question.points[i], kCalls);
    addRimPoints(writer, draw, drawn.question.scene, drawn.question.points.front());
    return drawn;
}

}  // namespace ticker::decision
