#include <grader/tasks/shadows/penumbra/PenumbraQuestion.h>
#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/shadows/questions/ShadowQuestions.h>
#include <grader/tasks/support/Draw.h>

#include <cmath>
#include <optional>
#include <utility>

namespace ticker::tasks {
namespace {

using Place = PenumbraQuestion::Place;

/// Points with a common purpose. How much of the light they see is given as a radius: of the
/// largest ball around the light's centre that the occluder hides, or, below 0, of the largest that
/// it leaves visible.
struct Wanted {
    Place::Kind kind;
    double low;  ///< in light sizes
    double high;
    std::size_t points;
    std::size_t calls;  ///< for each point
};

// Points between the middle and the rim show most of the light's size, the others its shape. A
// shadow bias of 1e-3 changes the visible part by less than 0.001 light sizes, since the occluder
// is seven times as far from the floor as from the light.
constexpr Wanted kWanted[] = {
    {Place::Kind::penumbra, 0.50, 0.62, 3, 2000},  {Place::Kind::penumbra, -0.62, -0.50, 3, 2000},
    {Place::Kind::penumbra, 0.20, 0.35, 2, 2000},  {Place::Kind::penumbra, -0.35, -0.20, 2, 2000},
    {Place::Kind::penumbra, 0.68, 0.76, 1, 2000},  {Place::Kind::penumbra, -0.76, -0.68, 1, 2000},
    {Place::Kind::beyondRim, 1.03, 1.08, 3, 1000}, {Place::Kind::withinRim, 0.82, 0.88, 3, 1000},
    {Place::Kind::atRim, 0.952, 0.962, 3, 3000},
};

constexpr int kMostAttempts = 20000;
constexpr int kFloorBelowTwo = 2;  // index of the floor, after two spheres

// In radii of the occluder, which hides everything that this sphere hides: only code that counts a
// ray once for each object it hits gives another result.
constexpr double kInnerRadius = 0.9;

// The radius that `Wanted` bounds, as a length.
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

// Points of the floor in the light's cone around the occluder, seen from the lens and from
// elsewhere.
class FloorPoints {
public:
    explicit FloorPoints(const probe::IlluminateQuestion& asked)
        : asked_(asked),
          light_(asked.scene.pointLights.front().position()),
          axis_((asked.scene.spheres.front().centre - light_).normalised()),
          rim_(std::asin(asked.scene.spheres.front().radius /
                         (asked.scene.spheres.front().centre - light_).magnitude())) {}

    // Empty if the ray meets the floor too far away.
    [[nodiscard]] std::optional<Vector3> next(Draw& draw) const {
        const raytracer::PlaneDescription& floor = asked_.scene.planes.front();
        const Vector3 ray = draw.directionAround(axis_, 2.2 * rim_);
        const double fall = ray.dot(floor.normal);
        if (fall > -0.2) return std::nullopt;
        return light_ + ray * ((floor.point - light_).dot(floor.normal) / fall);
    }
    // In light sizes.
    [[nodiscard]] double hiddenFrom(const Vector3& point) const {
        return hiddenRadius(asked_.scene, point) / asked_.settings.lightSize;
    }
    [[nodiscard]] probe::LitPoint lit(Draw& draw, const Vector3& point, bool fromLens) const {
        const Vector3& up = asked_.scene.planes.front().normal;
        return {
            kFloorBelowTwo, point, up,
            fromLens ? drawLensPoint(draw, asked_.settings) : drawViewer(draw, point, up, light_)};
    }

private:
    const probe::IlluminateQuestion& asked_;
    Vector3 light_;
    Vector3 axis_;
    double rim_;
};

}  // namespace

PenumbraQuestion drawPenumbraQuestion(std::uint64_t seed) {
    // Drawn like the questions with visible rays. In the second one the occluder is next to the
    // light.
    const std::uint64_t own = seed ^ 0x50454E554D425241U;
    PenumbraQuestion drawn;
    Draw draw{own, 24};
    const std::vector<ShadowQuestion> all = drawShadowQuestions(own);
    const ShadowQuestion& near = all[1];
    drawn.question.scene = near.question.scene;
    drawn.question.settings = near.question.settings;
    raytracer::SphereDescription inner = drawn.question.scene.spheres.front();
    inner.radius *= kInnerRadius;
    drawn.question.scene.spheres.push_back(std::move(inner));
    Writer writer{drawn, draw};
    const FloorPoints points{drawn.question};
    for (const Wanted& wanted : kWanted) {
        std::size_t found = 0;
        for (int attempt = 0; attempt < kMostAttempts && found < wanted.points; ++attempt) {
            const std::optional<Vector3> point = points.next(draw);
            if (!point) continue;
            const double hidden = points.hiddenFrom(*point);
            if (hidden < wanted.low || hidden > wanted.high) continue;
            const bool fromLens = drawn.places.size() % 2 == 1;
            writer.add(wanted.kind, points.lit(draw, *point, fromLens), wanted.calls);
            ++found;
        }
    }
    return drawn;
}

}  // namespace ticker::tasks
