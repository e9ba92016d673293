#include <bump/AxisAnswers.h>
#include <questions/BumpQuestions.h>
#include <support/TestDraws.h>

#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

namespace raytracer::tests::bump {
namespace {

constexpr int kAcross = 90;
constexpr double kByte = kBumpFactor / 255.0;

std::vector<double> inWholeBytes(std::vector<double> heights) {
    for (double& height : heights)
        height = kByte * static_cast<double>(std::lround(height / kByte) % 256);
    return heights;
}

/// Number of points that are asked for around one place.
constexpr std::size_t kBeside = 64;

std::vector<Vector3> directionsBeside(const std::vector<Vector3>& places) {
    constexpr double kReach = 0.08;  // radians: some twenty texels
    Draws draws{21};
    std::vector<Vector3> directions;
    for (const Vector3& place : places)
        for (std::size_t i = 0; i < kBeside; ++i)
            directions.push_back((place + draws.direction() * kReach).normalised());
    return directions;
}

using Tilts = std::span<const Vector3>;

double medianOf(Tilts tilts, auto&& part) {
    std::vector<double> values;
    for (const Vector3& tilt : tilts)
        values.push_back(part(tilt));
    return median(std::move(values));
}

/// Mean of the tilts near the median: points at a step from 255 to 0 are left out.
Vector3 steadyMean(Tilts tilts, double reach) {
    const Vector3 middle{medianOf(tilts, [](const Vector3& tilt) { return tilt.x; }),
                         medianOf(tilts, [](const Vector3& tilt) { return tilt.y; }),
                         medianOf(tilts, [](const Vector3& tilt) { return tilt.z; })};
    Vector3 sum;
    double count = 0.0;
    for (const Vector3& tilt : tilts) {
        if (!((tilt - middle).magnitude() <= reach)) continue;
        sum += tilt;
        count += 1.0;
    }
    return sum / count;
}

/// Evaluates the points' tilts on the ramp and on the bow.
AxisAnswers answersFrom(std::vector<Vector3> onRamp, const std::vector<Vector3>& onBow) {
    AxisAnswers answers;
    for (std::size_t i = 0; i < onRamp.size(); ++i)
        answers.places.push_back(questions::placeFromTilts(onRamp[i], onBow[i]));
    answers.tilts = std::move(onRamp);
    return answers;
}

HeightMap mapAlong(bool u, const std::vector<double>& heights) {
    const std::vector<double> across = questions::level(kAcross);
    return u ? mapOf(heights, across) : mapOf(across, heights);
}

/// On a map of whole bytes, differences of heights have the right slope on average only, so that
/// normals are asked for at many points around each place.
AxisAnswers askCoarsely(bool u, int bytesPerTexel, const std::vector<Vector3>& directions) {
    const double rise = bytesPerTexel * kByte * (kRampTexels - 1);
    const std::vector<Vector3> around = directionsBeside(directions);
    const auto tiltsOnBytes = [&](std::vector<double> heights) {
        return tiltsBeyondFlat(mapAlong(u, inWholeBytes(std::move(heights))), around);
    };
    const std::vector<Vector3> ramp = tiltsOnBytes(questions::ramp(kRampTexels, rise));
    const std::vector<Vector3> bow = tiltsOnBytes(questions::bow(kRampTexels, rise));
    std::vector<Vector3> onRamp;
    std::vector<Vector3> onBow;
    for (std::size_t from = 0; from < around.size(); from += kBeside) {
        const Tilts tilts = Tilts{ramp}.subspan(from, kBeside);
        const double reach =
            0.25 * medianOf(tilts, [](const Vector3& tilt) { return tilt.magnitude(); });
        onRamp.push_back(steadyMean(tilts, reach));
        onBow.push_back(steadyMean(Tilts{bow}.subspan(from, kBeside), reach));
    }
    return answersFrom(std::move(onRamp), onBow);
}

}  // namespace

AxisAnswers askAlong(bool u, const Slope& slope, const std::vector<Vector3>& directions) {
    if (slope.bytesPerTexel > 0) return askCoarsely(u, slope.bytesPerTexel, directions);
    const auto tilts = [&](const std::vector<double>& heights) {
        return tiltsBeyondFlat(mapAlong(u, heights), directions);
    };
    return answersFrom(tilts(questions::ramp(kRampTexels, slope.rise)),
                       tilts(questions::bow(kRampTexels, slope.rise)));
}

}  // namespace raytracer::tests::bump
