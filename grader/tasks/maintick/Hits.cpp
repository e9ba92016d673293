#include <grader/tasks/maintick/Hits.h>
#include <grader/tasks/support/Finite.h>
#include <grader/tasks/support/RunEnd.h>

#include <fmt/core.h>

#include <utility>
#include <variant>

namespace ticker::tasks::maintick {
namespace {

using Hits = std::vector<probe::Hit>;
using Asked = std::vector<AskedHit>;

bool isRight(const probe::Hit& hit, const std::optional<double>& distance, double tolerance) {
    if (hit.isHit != distance.has_value()) return false;
    if (!distance) return true;
    return std::isnan(*distance) ? std::isnan(hit.distance)
                                 : isNear(hit.distance, *distance, tolerance);
}

std::optional<double> distanceOf(const AskedHit& asked) {
    return asked.expected ? std::optional{asked.expected->distance} : std::nullopt;
}

std::string askedOf(const AskedHit& asked) {
    return fmt::format("A ray from {} in direction {} was asked of {}", words(asked.ray.origin),
                       words(asked.ray.direction), asked.object);
}

std::string expectedOf(const AskedHit& asked) {
    return asked.expected ? fmt::format("a hit at distance {:.4g}", asked.expected->distance)
                          : "no hit";
}

std::string gotOf(const probe::Hit& hit) {
    return hit.isHit ? fmt::format("a hit at distance {:.4g}", hit.distance) : "no hit";
}

const FindingText& nameOf(const AskedHit& asked, const probe::Hit& hit, const HitTexts& texts) {
    switch (asked.place) {
        case Place::behind:
            return *texts.behind;
        case Place::past:
            return *texts.phantom;
        case Place::inside:
            return *texts.inside;
        default:
            return hit.isHit ? *texts.distance : *texts.missed;
    }
}

/// A finding about the first wrong distance, under the name of the known mistake that explains all
/// distances, if there is one.
std::optional<Finding> checkDistances(const raytracer::SceneDescription& scene, const Asked& asked,
                                      const Hits& hits, std::span<const HitMistake> mistakes,
                                      const HitTexts& texts) {
    const auto isAsMistaken = [&](std::size_t i, const HitMistake* mistake) {
        if (asked[i].place == Place::longDirection) return true;
        const bool mayBeRight = mistake == nullptr || mistake->isSometimes;
        if (mayBeRight && isRight(hits[i], distanceOf(asked[i]), asked[i].tolerance)) return true;
        return mistake != nullptr &&
               isRight(hits[i], mistake->distance(scene, asked[i].ray.object, asked[i].line()),
                       asked[i].tolerance);
    };
    const auto first = firstWrong(asked.size(), nullptr, isAsMistaken);
    if (!first) return std::nullopt;
    const AskedHit& wrong = asked[*first];
    const std::string seen = fmt::format("{}: expected {}, got {}.", askedOf(wrong),
                                         expectedOf(wrong), gotOf(hits[*first]));
    if (auto known = nameMistake(mistakes, asked.size(), isAsMistaken, seen)) return known;
    return failure(nameOf(wrong, hits[*first], texts), seen);
}

std::optional<Finding> checkLocation(const AskedHit& asked, const probe::Hit& hit,
                                     const HitTexts& texts) {
    if (isNear(hit.location, asked.expected->location)) return std::nullopt;
    const bool leavesOriginOut =
        isNear(hit.location, asked.ray.direction * asked.expected->distance);
    return failure(*texts.location,
                   fmt::format("{}: expected the location {}, got {}.", askedOf(asked),
                               words(asked.expected->location), words(hit.location)),
                   leavesOriginOut ? "The origin of the ray is left out: the location is O + s D, "
                                     "ray.evaluateAt(distance)."
                                   : "");
}

/// Whether the normal is turned towards the origin of the ray. The handout does not say which way
/// it points, and only back faces look different.
bool isTurned(const AskedHit& asked, const probe::Hit& hit) {
    const Vector3 expected = asked.expected->normal;
    return asked.ray.direction.dot(expected) > 0.0 && isNear(hit.normal, expected * -1.0);
}

std::optional<Finding> checkNormal(const AskedHit& asked, const probe::Hit& hit,
                                   const HitTexts& texts) {
    const Vector3 expected = asked.expected->normal;
    if (isNear(hit.normal, expected) || isTurned(asked, hit)) return std::nullopt;
    const double length = hit.normal.magnitude();
    const bool isAlong = isNear(hit.normal, expected * length);
    std::string hint = texts.normalHint;
    if (isNear(hit.normal, expected * -1.0))
        hint =
            "It points the wrong way: exchange the two sides of the subtraction, or leave out "
            "the minus. getNormalAt(location) gives the right one.";
    else if (isFinite(hit.normal) && isAlong)
        hint = fmt::format(
            "It has the length {:.4g}: add .normalised(), or use getNormalAt(location).", length);
    return failure(*texts.normal,
                   fmt::format("{}: expected the normal {}, got {}.", askedOf(asked),
                               words(expected), words(hit.normal)),
                   hint);
}

std::optional<Finding> checkFields(const Asked& asked, const Hits& hits, const HitTexts& texts) {
    std::optional<Finding> location;
    std::optional<Finding> normal;
    std::optional<Finding> object;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        if (asked[i].place == Place::longDirection || !asked[i].expected) continue;
        if (!location) location = checkLocation(asked[i], hits[i], texts);
        if (!normal) normal = checkNormal(asked[i], hits[i], texts);
        if (!object && hits[i].object != asked[i].ray.object)
            object = failure(*texts.object, askedOf(asked[i]) +
                                                ": the hit should name this object, and names "
                                                "another or none.");
    }
    return location ? location : normal ? normal : object;
}

std::optional<Finding> noteTurned(const Asked& asked, const Hits& hits, const HitTexts& texts) {
    for (std::size_t i = 0; i < asked.size(); ++i)
        if (asked[i].expected && isTurned(asked[i], hits[i]))
            return distributedFinding(*texts.turned, Severity::note,
                                      askedOf(asked[i]) +
                                          ": the normal is turned to the side "
                                          "that the ray comes from.");
    return std::nullopt;
}

/// Compares locations only: along a long direction, code may count the distance in lengths of the
/// direction or in world units.
std::optional<Finding> checkLongDirections(const Asked& asked, const Hits& hits,
                                           const HitTexts& texts) {
    for (std::size_t i = 0; i < asked.size(); ++i) {
        if (asked[i].place != Place::longDirection) continue;
        if (hits[i].isHit && isNear(hits[i].location, asked[i].expected->location)) continue;
        return distributedFinding(*texts.length, Severity::note,
                                  askedOf(asked[i]) +
                                      ": the location is another than with a "
                                      "direction of length 1.");
    }
    return std::nullopt;
}

}  // namespace

TaskJudgement judgeHits(probe::Examinee& examinee, const raytracer::SceneDescription& scene,
                        const std::vector<AskedHit>& asked, std::span<const HitMistake> mistakes,
                        const HitTexts& texts, const std::string& function) {
    probe::HitQuestion question{scene, {}};
    for (const AskedHit& one : asked)
        question.rays.push_back(one.ray);
    const probe::Run run = examinee.ask({question});
    if (auto blocked = judgeUnanswered(run, function)) return *std::move(blocked);
    const Hits& hits = std::get<probe::HitAnswer>(run.answers.at(0)).hits;
    std::vector<Finding> findings;
    if (auto wrong = checkDistances(scene, asked, hits, mistakes, texts))
        findings.push_back(*std::move(wrong));
    else if (auto field = checkFields(asked, hits, texts))
        findings.push_back(*std::move(field));
    if (!hasFailure(findings)) {
        for (auto note : {checkLongDirections(asked, hits, texts), noteTurned(asked, hits, texts)})
            if (note) findings.push_back(*std::move(note));
    }
    return judgementOf(std::move(findings), texts.order);
}

}  // namespace ticker::tasks::maintick
