#include <grader/tasks/bump/places/Belts.h>

#include <grader/tasks/bump/questions/Numbers.h>

#include <cmath>

namespace ticker::tasks::bump {
namespace {

constexpr std::size_t kPlanes = 3;
constexpr std::size_t kQuarters = 4;
constexpr double kNarrow = 0.008;  // of the coordinate that is nearly 0, for a sphere of radius 1
constexpr double kWide = 0.03;

/// Which plane and which quarter of it the n-th point lies beside.
std::size_t beltOf(std::size_t n) {
    return n % (kPlanes * kQuarters);
}

Vector3 besidePlane(Draws& draws, std::size_t belt) {
    const double sign = draws.integer(0, 1) == 0 ? 1.0 : -1.0;
    const double little = sign * kNarrow * std::pow(kWide / kNarrow, draws.uniform(0.0, 1.0));
    const double turn =
        // NOLINTNEXTLINE(bugprone-integer-division): a whole number of quarters
        (static_cast<double>(belt / kPlanes) + draws.uniform(0.05, 0.95)) * kTurn / kQuarters;
    const double ring = std::sqrt(1.0 - little * little);
    const double one = ring * std::cos(turn);
    const double other = ring * std::sin(turn);
    const std::array<Vector3, kPlanes> beside{
        {{little, one, other}, {one, little, other}, {one, other, little}}};
    return beside.at(belt % kPlanes);
}

std::vector<double> wave(int count, double phase) {
    constexpr double kBase = 1.25;
    std::vector<double> heights;
    for (int i = 0; i < count; ++i)
        heights.push_back(kBase + std::cos(kTurn * (i + 0.5) / count + phase));
    return heights;
}

/// Points that count, and those that lean to the wrong side.
struct Tally {
    double counted = 0.0;
    double wrong = 0.0;
    double tilt = 0.0;  ///< sum of their tilts along the axis, without signs

    /// @param rise   Of the wave along the axis, as a share of the steepest.
    /// @param along  The tilt along it.
    void add(double rise, double along) {
        constexpr double kSteep = 0.4;
        if (std::abs(rise) < kSteep) return;
        counted += 1.0;
        tilt += std::abs(along);
        if (!(along * rise < 0.0)) wrong += 1.0;  // a raised bump leans away from the rise
    }

    [[nodiscard]] double share() const {
        constexpr double kFewest = 12.0;
        return counted < kFewest ? 0.0 : wrong / counted;
    }
};

/// Tallies of one axis, one for each belt.
using Axis = std::array<Tally, kPlanes * kQuarters>;

double meanTilt(const Axis& axis) {
    double counted = 0.0;
    double tilt = 0.0;
    for (const Tally& tally : axis) {
        counted += tally.counted;
        tilt += tally.tilt;
    }
    return counted > 0.0 ? tilt / counted : 0.0;
}

/// The worst belt of `axis`; none where tilts along the other axis hide those along this one: the
/// parametrisation is measured, and its directions are off by 8e-5, at most 0.0025 (median and
/// maximum of the accepted readings with heights as given, one under each of 400 seeds).
Belts worstOf(const Axis& axis, const Axis& other) {
    constexpr double kWeakest = 1.0 / 200.0;
    Belts worst;
    if (meanTilt(axis) < kWeakest * meanTilt(other)) return worst;
    for (std::size_t belt = 0; belt < axis.size(); ++belt)
        if (axis[belt].share() > worst.wrong) worst = {axis[belt].share(), "xyz"[belt % kPlanes]};
    return worst;
}

bool isFarFromEdges(const Parametrisation& parametrisation, const Vector3& n) {
    constexpr double kFromSeam = 0.05;
    constexpr double kFromPole = 0.12;
    const double v = parametrisation.v(n);
    return v > kFromPole && v < 1.0 - kFromPole &&
           turnDistance(parametrisation.u(n), 0.0) > kFromSeam;
}

}  // namespace

BeltPlan planBelts(Questionnaire& questionnaire, Draws& draws, const Ball& ball) {
    constexpr std::size_t kPoints = 60 * kPlanes * kQuarters;
    BeltPlan plan;
    for (std::size_t i = 0; i < kPoints; ++i)
        plan.directions.push_back(besidePlane(draws, beltOf(i)));
    const int width = draws.integer(90, 110);
    const int height = draws.integer(60, 80);
    plan.flat = questionnaire.add(ball, flatMap(width, height), plan.directions);
    const double phaseU = draws.uniform(0.0, kTurn);
    const double phaseV = draws.uniform(0.0, kTurn);
    for (std::size_t i = 0; i < plan.waves.size(); ++i) {
        const double later = static_cast<double>(i) * kTurn / 6.0;
        BeltPlan::Wave& asked = plan.waves.at(i);
        asked = {0, phaseU + later, phaseV + later};
        asked.question = questionnaire.add(
            ball, {width, height, {}, wave(width, asked.phaseU), wave(height, asked.phaseV)},
            plan.directions);
    }
    return plan;
}

Belts readBelts(const BeltPlan& plan, const Answers& answers,
                const Parametrisation& parametrisation, const Response& response) {
    Axis onU;
    Axis onV;
    for (const BeltPlan::Wave& asked : plan.waves) {
        const std::vector<Vector3> tilts = answers.tiltsBeyond(plan.flat, asked.question);
        for (std::size_t i = 0; i < tilts.size(); ++i) {
            const Vector3& n = plan.directions[i];
            if (!isFarFromEdges(parametrisation, n)) continue;
            const double riseU = -std::sin(kTurn * parametrisation.u(n) + asked.phaseU);
            const double riseV = -std::sin(kTurn * parametrisation.v(n) + asked.phaseV);
            const double tiltU = response.u.sign() * tilts[i].dot(parametrisation.alongU(n));
            const double tiltV = response.v.sign() * tilts[i].dot(parametrisation.alongV(n));
            onU.at(beltOf(i)).add(riseU, tiltU);
            onV.at(beltOf(i)).add(riseV, tiltV);
        }
    }
    const Belts alongU = worstOf(onU, onV);
    const Belts alongV = worstOf(onV, onU);
    return alongV.wrong > alongU.wrong ? alongV : alongU;
}

}  // namespace ticker::tasks::bump
