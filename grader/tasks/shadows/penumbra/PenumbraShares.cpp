#include <grader/tasks/shadows/answers/Phong.h>
#include <grader/tasks/shadows/answers/ShadowReplay.h>
#include <grader/tasks/shadows/penumbra/PenumbraShares.h>
#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Bounds.h>

#include <algorithm>
#include <cmath>

namespace ticker::tasks {
namespace {

constexpr int kAimsOfAShare = 8192;

// Error bound of a share that is counted on the lattice (measured against 65536 points).
constexpr double kShareError = 0.0025;

double total(const ColourRGB& colour) {
    return colour.r + colour.g + colour.b;
}

PointLog bare(const probe::LitPoint& point) {
    PointLog log;
    log.point = point;
    log.lines.resize(1);
    log.zones = {Zone::penumbra};
    return log;
}

// Distance from `start` to the ball's surface along a line that hits the ball.
double nearSide(const Vector3& start, const Vector3& direction, const Vector3& centre,
                double radius) {
    const Vector3 toCentre = centre - start;
    const double middle = toCentre.dot(direction);
    const double off = toCentre.dot(toCentre) - middle * middle;
    return middle - std::sqrt(std::max(0.0, radius * radius - off));
}

// Sum over points of weight * (seen - expected), in units of Bernstein's bound.
double excess(const std::vector<PenumbraSamples>& seen, const std::vector<double>& expected,
              const std::vector<double>& weights) {
    const double logRisk = std::log(2.0 / kStatementRisk);
    double sum = 0.0;
    double variance = 0.0;
    double most = 0.0;
    double slack = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const auto calls = static_cast<double>(seen[i].shares.size());
        sum += weights[i] * (seen[i].mean - expected[i]);
        // The variance is estimated from the calls; the factor 1.5 and the floor cover the
        // estimate's error.
        variance += weights[i] * weights[i] * (1.5 * seen[i].variance + 0.002) / calls;
        most = std::max(most, std::abs(weights[i]) / calls);
        slack += std::abs(weights[i]) * kShareError;
    }
    const double bound = std::sqrt(2.0 * variance * logRisk) + most * logRisk / 3.0 + slack;
    return std::abs(sum) / bound;
}

}  // namespace

PenumbraSamples readSamples(const PenumbraQuestion& asked, const probe::IlluminateAnswer& answer,
                            const PenumbraQuestion::Place& place) {
    PenumbraSamples samples;
    samples.place = place;
    samples.point = asked.question.points[place.first];
    const raytracer::SceneDescription& scene = asked.question.scene;
    const PointLog log = bare(samples.point);
    const double ambient = total(ambientPart(log, scene));
    const double full = total(unshadowed(log, scene, 0, false));
    const auto calls = static_cast<double>(place.calls);
    for (std::size_t i = place.first; i < place.first + place.calls; ++i)
        samples.shares.push_back((total(answer.colours[i]) - ambient) / full);
    for (const double share : samples.shares)
        samples.mean += share / calls;
    for (const double share : samples.shares)
        samples.variance += (share - samples.mean) * (share - samples.mean) / (calls - 1.0);
    return samples;
}

ExpectedShares expectedAt(const probe::IlluminateQuestion& asked, const Surfaces& surfaces,
                          const probe::LitPoint& point, AimShape shape, double size) {
    const raytracer::PointLight& light = asked.scene.pointLights[0];
    const raytracer::Material& material = materialOf(asked.scene, point.object);
    const PointLog log = bare(point);
    const double full = total(unshadowed(log, asked.scene, 0, false));
    const double centre = (light.position() - point.position).magnitude();
    const double radius = size * asked.settings.lightSize;
    const std::array<double, 2> central{
        1.0 / kAimsOfAShare, total(unshadowed(log, asked.scene, 0, true)) / full / kAimsOfAShare};
    const Vector3 start = rayStart(point.position, point.normal);
    ExpectedShares expected;
    for (const Vector3& place : aimsOf(shape, kAimsOfAShare)) {
        const Vector3 aim = light.position() + place * radius;
        const Vector3 towards = aim - start;
        const double distance = towards.magnitude();
        if (surfaces.sightAlong(start, towards / distance, distance) == Sight::blocked) continue;
        expected.open += 1.0 / kAimsOfAShare;
        const double nearest = nearSide(start, towards / distance, light.position(), radius);
        const std::array<double, 3> falloff{1.0, centre * centre / (distance * distance),
                                            centre * centre / (nearest * nearest)};
        for (const std::size_t eye : {0U, 1U}) {
            const Vector3 viewer = eye == 1 ? Vector3{} : point.viewer;
            const double own =
                total(phongTerms(material, light, point.normal,
                                 (viewer - point.position).normalised(), towards / distance, centre)
                          .sum()) /
                full / kAimsOfAShare;
            for (std::size_t i = 0; i < falloff.size(); ++i) {
                expected.share[eye][i] += central[eye] * falloff[i];
                expected.share[eye][falloff.size() + i] += own * falloff[i];
            }
        }
    }
    return expected;
}

double worstExcess(const std::vector<PenumbraSamples>& seen, const std::vector<double>& expected,
                   const std::vector<double>& open) {
    std::vector<double> even(seen.size(), 1.0);
    std::vector<double> wider;
    for (const double share : open)
        wider.push_back(0.5 - share);  // a larger light moves every share towards one half
    double worst = std::max(excess(seen, expected, even), excess(seen, expected, wider));
    for (std::size_t i = 0; i < seen.size(); ++i) {
        std::vector<double> single(seen.size(), 0.0);
        single[i] = 1.0;
        worst = std::max(worst, excess(seen, expected, single));
    }
    return worst;
}

}  // namespace ticker::tasks
