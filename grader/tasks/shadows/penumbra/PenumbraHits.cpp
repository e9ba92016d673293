#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/penumbra/PenumbraHits.h>
#include <grader/tasks/support/FindingOrder.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace ticker::tasks {
namespace {

// The mean share of code that subtracts a ray's part of the light for each sphere that it hits.
// @param outer  Share of the rays that hit the occluder.
// @param inner  Share of these that hit the sphere inside it, too.
double shareLessEveryHit(double outer, double inner) {
    const int rays = raytracer::RenderSettings{}.shadowRayCount;
    std::vector<double> chance{1.0};  // of each number of hits
    for (int ray = 0; ray < rays; ++ray) {
        std::vector<double> next(chance.size() + 2);
        for (std::size_t hits = 0; hits < chance.size(); ++hits) {
            next[hits] += chance[hits] * (1.0 - outer);
            next[hits + 1] += chance[hits] * (outer - inner);
            next[hits + 2] += chance[hits] * inner;
        }
        chance = std::move(next);
    }
    double mean = 0.0;
    for (int hits = 0; hits < rays; ++hits)
        mean += chance[static_cast<std::size_t>(hits)] * (rays - hits) / rays;
    return mean;
}

}  // namespace

bool countsEveryHit(PenumbraExpectations& expectations, const std::vector<PenumbraSamples>& seen) {
    constexpr double kNear = 0.05;
    const probe::IlluminateQuestion& asked = expectations.asked().question;
    raytracer::SceneDescription small = asked.scene;
    small.spheres.front() = small.spheres.back();
    const Surfaces inner{small};
    return std::all_of(seen.begin(), seen.end(), [&](const PenumbraSamples& samples) {
        const double open = expectations.at(samples.place, AimShape::ball).open;
        const double openInside = expectedAt(asked, inner, samples.point, AimShape::ball, 1.0).open;
        return std::abs(samples.mean - shareLessEveryHit(1.0 - open, 1.0 - openInside)) < kNear;
    });
}

Finding everyHitCounts() {
    Finding finding = distributedFinding(
        kShadowWrong, Severity::fail,
        "Where a ray meets two objects before the light it was expected to count once; its part of "
        "the light is taken away twice, so that the edges of such shadows are too dark.");
    finding.hint =
        "Count the rays that are blocked, not the hits: end the loop over the objects (break) at "
        "the first one before the light, or ask scene.findClosestIntersection(shadowRay).";
    finding.section = "Soft shadows (T2.1), step 1";
    return finding;
}

}  // namespace ticker::tasks
