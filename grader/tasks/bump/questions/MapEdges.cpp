#include <grader/tasks/bump/questions/MapEdges.h>

#include <grader/tasks/bump/questions/Numbers.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace ticker::tasks::bump {
namespace {

// An unsigned -1 is far inside of such a map: 2^32 - 1 is texel 43 of 76, 2^64 - 1 texel 35.
constexpr int kEdgeMapWidth = 76;
constexpr int kEdgeMapHeight = 76;

/// One wave, from 0.3 above `base` near both ends to 0.3 below it in the middle. It rises by at
/// most 2 bytes from one texel to the next.
std::vector<double> waves(int count, double base, double phase) {
    constexpr double kLift = 0.3;
    std::vector<double> heights;
    for (int i = 0; i < count; ++i)
        heights.push_back(base + kLift * std::cos(kTurn * (i + 0.5) / count + phase));
    return heights;
}

/// Rings within the first or last row, for poles on any axis.
void addEndRows(std::vector<Vector3>& directions) {
    constexpr int kPoints = 12;
    constexpr double kFromPole = 0.03;  // radians; a row has 0.041
    for (const Vector3& axis : {Vector3{0, 1, 0}, Vector3{0, 0, 1}, Vector3{1, 0, 0}})
        for (int i = 0; i < kPoints; ++i) {
            const double turn = kTurn * (i + 0.3) / kPoints;
            const Vector3 across{axis.y, axis.z, axis.x};
            const Vector3 beside = across * std::cos(turn) + axis.cross(across) * std::sin(turn);
            directions.push_back((axis + beside * kFromPole).normalised());
            directions.push_back((beside * kFromPole - axis).normalised());
        }
}

enum class Where { edge, elsewhere, neither };

/// Second largest tilt at the edge divided by the largest elsewhere: one outlier is allowed.
double ratioOf(const std::vector<Vector3>& directions, const std::vector<Vector3>& tilts,
               const std::function<Where(const Vector3&)>& whereIs) {
    double largest = 0.0;
    double second = 0.0;
    double elsewhere = 0.0;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const double length = tilts[i].magnitude();
        const Where where = whereIs(directions[i]);
        if (!std::isfinite(length) || where == Where::neither) continue;
        if (where == Where::elsewhere) {
            elsewhere = std::max(elsewhere, length);
        } else if (length > largest) {
            second = largest;
            largest = length;
        } else {
            second = std::max(second, length);
        }
    }
    return elsewhere > 0.0 ? second / elsewhere : 1.0;
}

}  // namespace

EdgePlan planEdges(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    // One column of 76 has 20 of the points that count, on average; the chance that fewer than two
    // points hit it is below five in a million.
    constexpr int kPoints = 1900;
    EdgePlan plan;
    plan.directions = draws.directions(kPoints);
    addEndRows(plan.directions);
    const double base = draws.uniform(3.6, 4.6);
    const double phase = draws.uniform(-0.5, 0.5);
    plan.flat =
        questionnaire.add(ball, flatMap(kEdgeMapWidth, kEdgeMapHeight, 0.0), plan.directions);
    plan.columnWaves = questionnaire.add(ball,
                                         {kEdgeMapWidth,
                                          kEdgeMapHeight,
                                          {},
                                          waves(kEdgeMapWidth, base, phase),
                                          raytracer::questions::level(kEdgeMapHeight)},
                                         plan.directions);
    plan.rowWaves = questionnaire.add(ball,
                                      {kEdgeMapWidth,
                                       kEdgeMapHeight,
                                       {},
                                       raytracer::questions::level(kEdgeMapWidth),
                                       waves(kEdgeMapHeight, base, phase)},
                                      plan.directions);
    return plan;
}

MapEdges readEdges(const EdgePlan& plan, const Answers& answers,
                   const Parametrisation& parametrisation) {
    constexpr double kNearSeam = 0.06;
    constexpr double kFarFromSeam = 0.1;
    constexpr double kNearPole = 0.06;
    constexpr double kFarFromPole = 0.2;
    const auto toPole = [&](const Vector3& n) {
        return std::min(parametrisation.v(n), 1.0 - parametrisation.v(n));
    };
    const auto bySeam = [&](const Vector3& n) {
        const double distance = turnDistance(parametrisation.u(n), 0.0);
        if (toPole(n) < kFarFromPole) return Where::neither;
        if (distance < kNearSeam) return Where::edge;
        return distance > kFarFromSeam ? Where::elsewhere : Where::neither;
    };
    const auto byPole = [&](const Vector3& n) {
        if (toPole(n) < kNearPole) return Where::edge;
        return bySeam(n) == Where::elsewhere ? Where::elsewhere : Where::neither;
    };
    return {ratioOf(plan.directions, answers.tiltsBeyond(plan.flat, plan.columnWaves), bySeam),
            ratioOf(plan.directions, answers.tiltsBeyond(plan.flat, plan.rowWaves), byPole)};
}

}  // namespace ticker::tasks::bump
