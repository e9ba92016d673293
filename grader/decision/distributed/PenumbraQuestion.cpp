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
constexpr std::size_t kAtRimCalls = 3000;

// In light sizes. A shadow bias of 1e-3 changes what a point sees by less than 0.001 of them, since
// the occluder stands seven times as far from the floor as from the light.
constexpr double kBeyondLow = 1.03;
constexpr double kBeyondHigh = 1.08;
constexpr double kWithinLow = 0.82;
constexpr double kWithinHigh = 0.88;
constexpr double kAtRimLow = 0.952;
constexpr double kAtRimHigh = 0.962;

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

// Points of the floor next to a given one, at random around the shadow's middle.
class RimPoints {
public:
    RimPoints(const raytracer::SceneDescription& scene, const probe::LitPoint& like)
        : scene_(scene),
          like_(like),
          light_(scene.pointLights.front().position()),
          axis_((scene.spheres.front().centre - light_).normalised()),
          rim_(std::asin(scene.spheres.front().radius /
                         (scene.spheres.front().centre - light_).magnitude())) {}

    [[nodiscard]] probe::LitPoint next(Draw& draw) const {
        const Vector3 ray = draw.directionAround(axis_, rim_);
        probe::LitPoint point = like_;
        point.position =
            light_ + ray * ((like_.position - light_).dot(like_.normal) / ray.dot(like_.normal));
        return point;
    }
    /// In light sizes.
    [[nodiscard]] double hiddenFrom(const probe::LitPoint& point) const {
        return hiddenRadius(scene_, point.position) / raytracer::RenderSettings{}.lightSize;
    }

private:
    const raytracer::SceneDescription& scene_;
    probe::LitPoint like_;
    Vector3 light_;
    Vector3 axis_;
    double rim_;
};

constexpr int kMostAttempts = 20000;

void addRimPoints(Writer& writer, Draw& draw, const RimPoints& points) {
    std::size_t beyond = 0;
    std::size_t within = 0;
    for (int attempt = 0; attempt < kMostAttempts && beyond + within < 2 * kRimPoints; ++attempt) {
        const probe::LitPoint point = points.next(draw);
        const double hidden = points.hiddenFrom(point);
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

void addPointsAtRim(Writer& writer, Draw& draw, const RimPoints& points) {
    std::size_t found = 0;
    for (int attempt = 0; attempt < kMostAttempts && found < kRimPoints; ++attempt) {
        const probe::LitPoint point = points.next(draw);
        const double hidden = points.hiddenFrom(point);
        if (hidden < kAtRimLow || hidden > kAtRimHigh) continue;
        writer.add(Place::Kind::atRim, point, kAtRimCalls);
        ++found;
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
    const RimPoints points{drawn.question.scene, drawn.question.points.front()};
    addRimPoints(writer, draw, points);
    addPointsAtRim(writer, draw, points);
    return drawn;
}

}  // namespace ticker::decision
