#include <grader/decision/bump/CoarseRamps.h>

#include <grader/decision/bump/Numbers.h>
#include <grader/decision/bump/RampLadder.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace ticker::decision::bump {
namespace {

constexpr std::size_t kPointsPerPlace = 16;
// Of 6 bytes for each texel the mean of 16 rounded slopes knows a bow's place to a hundredth.
constexpr int kBytesPerTexel = 6;

/// A point within about ten texels.
Vector3 beside(const Vector3& place, Draws& draws) {
    constexpr double kReach = 0.04;  // radians
    return (place + draws.direction() * draws.uniform(0.0, kReach)).normalised();
}

/// Mean of the tilts that are no longer than `longest`.
class ShortMean {
public:
    explicit ShortMean(double longest) : longest_(longest) {}

    void add(const Vector3& tilt) {
        if (!(tilt.magnitude() <= longest_)) return;
        sum_ += tilt;
        count_ += 1.0;
    }
    [[nodiscard]] Vector3 value() const { return sum_ / count_; }

private:
    double longest_;
    Vector3 sum_;
    double count_ = 0.0;
};

using Points = std::vector<RampTilts>;

/// The longest tilt that is no step, from the middle one on the ramp.
double longestOf(const Points& points, Vector3 RampTilts::*ramp) {
    constexpr double kStep = 3.0;
    std::vector<double> lengths;
    std::transform(points.begin(), points.end(), std::back_inserter(lengths),
                   [ramp](const RampTilts& tilt) { return (tilt.*ramp).magnitude(); });
    return kStep * median(lengths);
}

RampTilts meanOf(const Points& points, const Vector3& place) {
    const double longestU = longestOf(points, &RampTilts::onURamp);
    const double longestV = longestOf(points, &RampTilts::onVRamp);
    ShortMean uRamp(longestU);
    ShortMean uBow(longestU);
    ShortMean vRamp(longestV);
    ShortMean vBow(longestV);
    for (const RampTilts& tilt : points) {
        uRamp.add(tilt.onURamp);
        uBow.add(tilt.onUBow);
        vRamp.add(tilt.onVRamp);
        vBow.add(tilt.onVBow);
    }
    return {place, uRamp.value(), uBow.value(), vRamp.value(), vBow.value()};
}

}  // namespace

CoarsePlan planCoarse(Draws& draws, const Ball& ball) {
    constexpr int kPlaces = 400;
    CoarsePlan plan;
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

}  // namespace ticker::decision::bump
