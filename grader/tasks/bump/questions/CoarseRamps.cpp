#include <grader/tasks/bump/questions/CoarseRamps.h>

#include <grader/tasks/bump/questions/Numbers.h>
#include <grader/tasks/bump/questions/RampLadder.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace ticker::tasks::bump {
namespace {

// With 2 bytes for each texel a tooth of the brighter half is 64 texels long, more than the points
// of a place cover; the mean of 128 rounded slopes gives a bow's place to a hundredth.
constexpr std::size_t kPointsPerPlace = 128;
constexpr int kBytesPerTexel = 2;

/// A random point within about thirty texels, most of a tooth.
Vector3 beside(const Vector3& place, Draws& draws) {
    constexpr double kReach = 0.08;  // radians
    return (place + draws.direction() * kReach).normalised();
}

using Points = std::vector<RampTilts>;
using Which = Vector3 RampTilts::*;

template <typename Part>
double medianOf(const Points& points, Part part) {
    std::vector<double> values;
    values.reserve(points.size());
    std::transform(points.begin(), points.end(), std::back_inserter(values), part);
    return median(values);
}

/// Mean of the tilts that lie within `reach` of the median: points at a step are left out.
Vector3 steadyMean(const Points& points, Which which, double reach) {
    const Vector3 middle{medianOf(points, [which](const RampTilts& t) { return (t.*which).x; }),
                         medianOf(points, [which](const RampTilts& t) { return (t.*which).y; }),
                         medianOf(points, [which](const RampTilts& t) { return (t.*which).z; })};
    Vector3 sum;
    double count = 0.0;
    for (const RampTilts& tilt : points) {
        if (!((tilt.*which - middle).magnitude() <= reach)) continue;
        sum += tilt.*which;
        count += 1.0;
    }
    return sum / count;
}

/// Tolerance of `steadyMean`: the tilt of a slope of two bytes for each texel, measured on the
/// ramp. Rounding changes a slope by one byte, the sphere's curvature by less than another.
double reachOf(const Points& points, Which ramp) {
    return 2.0 / kBytesPerTexel * medianLength(points, ramp);
}

RampTilts meanOf(const Points& points, const Vector3& place) {
    const double reachU = reachOf(points, &RampTilts::onURamp);
    const double reachV = reachOf(points, &RampTilts::onVRamp);
    return {place, steadyMean(points, &RampTilts::onURamp, reachU),
            steadyMean(points, &RampTilts::onUBow, reachU),
            steadyMean(points, &RampTilts::onVRamp, reachV),
            steadyMean(points, &RampTilts::onVBow, reachV)};
}

}  // namespace

CoarsePlan planCoarse(Draws& draws, const Ball& ball) {
    constexpr int kPlaces = 300;
    CoarsePlan plan;
    plan.questionnaire = Questionnaire(static_cast<std::uint64_t>(draws.integer(0, 1 << 30)));
    plan.places = draws.directions(kPlaces);
    std::vector<Vector3> points;
    for (const Vector3& place : plan.places)
        for (std::size_t i = 0; i < kPointsPerPlace; ++i)
            points.push_back(beside(place, draws));
    RampShape shape = drawShape(draws, raytracer::kBumpFactor);
    shape.bytesPerTexel = kBytesPerTexel;
    plan.ramps = planRamps(plan.questionnaire, ball, shape, std::move(points));
    return plan;
}

std::vector<RampTilts> readCoarse(const CoarsePlan& plan, const Answers& answers) {
    const std::vector<RampTilts> all = readRamps(plan.ramps, answers);
    std::vector<RampTilts> means;
    means.reserve(plan.places.size());
    auto next = all.begin();
    for (const Vector3& place : plan.places) {
        const auto end = next + kPointsPerPlace;
        means.push_back(meanOf(Points(next, end), place));
        next = end;
    }
    return means;
}

}  // namespace ticker::tasks::bump
