#include <grader/tasks/shadows/answers/LightParts.h>

#include <raytracer/render/Renderer.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <utility>

namespace ticker::tasks {
namespace {

using Phong = ShadowReading::Phong;
using Terms = ShadowReading::Terms;

// Whether a line enters the ball through the half of its surface that faces the point, but does not
// leave through it. Near the rim it does both, but its chord is short there.
// @param half    Half the length of the chord.
// @param centre  Distance of the ball's centre from the point.
bool entersAlone(double half, double radius, double centre) {
    constexpr double kBias = 1.05;  // rays start beside the point
    return half > kBias * radius * radius / centre;
}

// The sample lies anywhere on the chord of the line in the light.
SampleTerms termsOf(const Setting& at, const AimLine& line) {
    const double centre = (at.light.position() - at.point.point.position).magnitude();
    if (at.reading.phong == Phong::perSampleDirection) {
        const PhongTerms terms = at.terms(line.direction, centre);
        return {{terms.diffuse, terms.diffuse}, {terms.specular, terms.specular}};
    }
    const double along = (at.light.position() - line.origin).dot(line.direction);
    const double radius = std::max(at.settings.lightSize, line.miss);
    const double half = std::sqrt(std::max(0.0, radius * radius - line.miss * line.miss));
    const Vector3 towards = at.reading.phong == Phong::perSample
                                ? line.direction
                                : (at.light.position() - at.point.point.position) / centre;
    const PhongTerms near = at.terms(towards, std::max(along - half, 0.1 * centre));
    if (at.reading.nearSide && entersAlone(half, radius, centre))
        return {{near.diffuse, near.diffuse}, {near.specular, near.specular}};
    const PhongTerms far = at.terms(towards, std::max(along + half, 0.1 * centre));
    return {{far.diffuse, near.diffuse}, {far.specular, near.specular}};
}

// How far the line misses the light's centre, world units: from its own start, or as if it started
// at the point, whichever is less.
double offCentre(const Setting& at, const AimLine& line) {
    const Vector3 towards = at.light.position() - at.point.point.position;
    const double distance = towards.magnitude();
    return std::min(line.miss, (line.direction - towards / distance).magnitude() * distance);
}

// Leaves out the most central line and its equals, if it aims at the centre. Other lines that pass
// as near are samples and count, since the samples of some accepted shapes crowd there.
std::vector<AimLine> withoutCentral(const Setting& at, const std::vector<AimLine>& lines) {
    constexpr double kEqual = 1e-9;
    const double exact = 1e-9 + 1.01 * biasOf(at.point);
    const auto central = std::ranges::min_element(
        lines, {}, [&](const AimLine& line) { return offCentre(at, line); });
    if (central == lines.end() || central->miss > exact) return lines;
    std::vector<AimLine> counted;
    std::ranges::copy_if(lines, std::back_inserter(counted), [&](const AimLine& line) {
        return line.isAdded || (line.direction - central->direction).magnitude() > kEqual;
    });
    return counted;
}

// Lines 0, 2, 4 and so on, then the others.
std::vector<AimLine> everySecondFirst(std::span<const AimLine> lines) {
    std::vector<AimLine> sorted;
    for (const std::size_t first : {0U, 1U})
        for (std::size_t i = first; i < lines.size(); i += 2)
            sorted.push_back(lines[i]);
    return sorted;
}

// Without logged rays every share is possible. A light behind the surface is the exception: it
// contributes nothing, and code may skip its rays.
LightParts partsWithoutRays(const Setting& at) {
    LightParts parts;
    const Vector3 towards = (at.light.position() - at.point.point.position).normalised();
    if (towards.dot(at.point.point.normal) <= 0.0) return parts;
    const SampleTerms full = centralTerms(at);
    parts.fullDiffuse = full.diffuse;
    parts.fullSpecular = full.specular;
    parts.litDiffuse = {{}, full.diffuse.high};
    parts.litSpecular = {{}, full.specular.high};
    parts.highShare = 1.0;
    return parts;
}

LightParts partsOf(const Setting& at, std::span<const AimLine> lines) {
    const double weight = 1.0 / static_cast<double>(lines.size());
    const bool sameForAll = at.reading.phong == Phong::central;
    SampleTerms terms = sameForAll ? centralTerms(at) : SampleTerms{};
    LightParts parts;
    parts.ray = weight;
    for (const AimLine& line : lines) {
        if (!sameForAll) terms = termsOf(at, line);
        parts.fullDiffuse += terms.diffuse * weight;
        parts.fullSpecular += terms.specular * weight;
        const Sight sight = at.endless ? line.endlessly : line.toLight;
        if (sight == Sight::blocked) continue;
        parts.litDiffuse.high += terms.diffuse.high * weight;
        parts.litSpecular.high += terms.specular.high * weight;
        parts.highShare += weight;
        if (sight == Sight::unsure) continue;
        parts.litDiffuse.low += terms.diffuse.low * weight;
        parts.litSpecular.low += terms.specular.low * weight;
        parts.lowShare += weight;
    }
    return parts;
}

}  // namespace

double biasOf(const PointLog& point) {
    double bias = 0.0;
    for (const std::vector<AimLine>& light : point.lines)
        for (const AimLine& line : light)
            bias = std::max(
                {bias, (line.origin - point.point.position).magnitude(), raytracer::kShadowBias});
    return std::min(bias, 2e-3);
}

SampleTerms centralTerms(const Setting& at) {
    const Vector3 towards = at.light.position() - at.point.point.position;
    const double distance = towards.magnitude();
    const PhongTerms terms = at.terms(towards / distance, distance);
    return {{terms.diffuse, terms.diffuse}, {terms.specular, terms.specular}};
}

LightParts partsOf(const Setting& at, const std::vector<AimLine>& logged) {
    std::vector<AimLine> some;
    std::span<const AimLine> lines{logged};
    if (at.reading.withoutCentral) lines = some = withoutCentral(at, logged);
    if (lines.empty()) return partsWithoutRays(at);
    const auto asked = static_cast<std::size_t>(at.settings.shadowRayCount);
    if (at.reading.terms == Terms::together || lines.size() < 2 * asked) return partsOf(at, lines);
    std::vector<AimLine> turns;
    if (at.reading.terms == Terms::inTurns) lines = turns = everySecondFirst(lines);
    const std::size_t half = lines.size() / 2;
    LightParts parts = partsOf(at, lines.first(half));
    LightParts ofSpecular = partsOf(at, lines.subspan(half));
    if (at.reading.specularFirst) std::swap(parts, ofSpecular);
    parts.fullSpecular = ofSpecular.fullSpecular;
    parts.litSpecular = ofSpecular.litSpecular;
    parts.lowShare = std::min(parts.lowShare, ofSpecular.lowShare);
    parts.highShare = std::max(parts.highShare, ofSpecular.highShare);
    return parts;
}

}  // namespace ticker::tasks
