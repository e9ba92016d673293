#include <grader/tasks/shadows/answers/Phong.h>
#include <grader/tasks/shadows/answers/ShadowReplay.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace ticker::tasks {
namespace {

using Phong = ShadowReading::Phong;
using raytracer::PointLight;
using raytracer::SceneDescription;

/// Interval of possible colours.
struct Range {
    ColourRGB low;
    ColourRGB high;

    Range& operator+=(const Range& other) {
        low += other.low;
        high += other.high;
        return *this;
    }
};

Range operator*(const Range& range, double scale) {
    return {range.low * scale, range.high * scale};
}

/// One light at one point: its full light, the light that arrives, and the share of rays that
/// arrive.
struct LightParts {
    Range fullDiffuse;
    Range fullSpecular;
    Range litDiffuse;
    Range litSpecular;
    double lowShare = 0.0;
    double highShare = 0.0;
};

/// One point, one light, one reading: input of the functions below.
struct Setting {
    const raytracer::Material& material;
    const PointLight& light;
    const PointLog& point;
    const raytracer::RenderSettings& settings;
    const ShadowReading& reading;
    bool endless;

    [[nodiscard]] Vector3 toViewer() const {
        const Vector3 viewer = reading.viewerIsEye ? Vector3{} : point.point.viewer;
        return (viewer - point.point.position).normalised();
    }
    [[nodiscard]] PhongTerms terms(const Vector3& toLight, double distance) const {
        return phongTerms(material, light, point.point.normal, toViewer(), toLight, distance);
    }
};

double biasOf(const PointLog& point) {
    double bias = 0.0;
    for (const std::vector<AimLine>& light : point.lines)
        for (const AimLine& line : light)
            bias = std::max(bias, (line.origin - point.point.position).magnitude());
    return std::min(bias, 2e-3);
}

struct SampleTerms {
    Range diffuse;
    Range specular;
};

SampleTerms centralTerms(const Setting& at) {
    const Vector3 towards = at.light.position() - at.point.point.position;
    const double distance = towards.magnitude();
    const PhongTerms terms = at.terms(towards / distance, distance);
    return {{terms.diffuse, terms.diffuse}, {terms.specular, terms.specular}};
}

// The sample lies anywhere on the chord of the line in the light.
SampleTerms termsOf(const Setting& at, const AimLine& line) {
    if (at.reading.phong == Phong::central) return centralTerms(at);
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
    const PhongTerms far = at.terms(towards, std::max(along + half, 0.1 * centre));
    return {{far.diffuse, near.diffuse}, {far.specular, near.specular}};
}

std::vector<AimLine> countedLines(const Setting& at, const std::vector<AimLine>& lines) {
    if (!at.reading.withoutCentral) return lines;
    std::vector<AimLine> counted;
    const double exact = 1e-9 + 1.01 * biasOf(at.point);
    std::copy_if(lines.begin(), lines.end(), std::back_inserter(counted),
                 [&](const AimLine& line) { return line.miss > exact; });
    return counted;
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
    LightParts parts;
    for (const AimLine& line : lines) {
        const SampleTerms terms = termsOf(at, line);
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

LightParts partsOf(const Setting& at, const std::vector<AimLine>& logged) {
    const std::vector<AimLine> counted = countedLines(at, logged);
    if (counted.empty()) return partsWithoutRays(at);
    const std::span<const AimLine> lines{counted};
    const auto asked = static_cast<std::size_t>(at.settings.shadowRayCount);
    if (!at.reading.termsApart || lines.size() < 2 * asked) return partsOf(at, lines);
    LightParts parts = partsOf(at, lines.first(lines.size() / 2));
    const LightParts again = partsOf(at, lines.last(lines.size() - lines.size() / 2));
    parts.fullSpecular = again.fullSpecular;
    parts.litSpecular = again.litSpecular;
    parts.lowShare = std::min(parts.lowShare, again.lowShare);
    parts.highShare = std::max(parts.highShare, again.highShare);
    return parts;
}

Range difference(const Range& whole, const Range& part) {
    return {whole.low - part.high, whole.high - part.low};
}

// True, false or either: a decision on a share that may be an interval.
Range decided(const Range& full, bool surely, bool possibly) {
    return {surely ? full.low : ColourRGB{}, possibly ? full.high : ColourRGB{}};
}

Range addedBy(const LightParts& parts, const ColourRGB& ambient, ShadowArithmetic arithmetic) {
    constexpr double kAll = 1.0 - 1e-9;
    Range full = parts.fullDiffuse;
    full += parts.fullSpecular;
    Range lit = parts.litDiffuse;
    lit += parts.litSpecular;
    switch (arithmetic) {
        case ShadowArithmetic::inverted:
            return difference(full, lit);
        case ShadowArithmetic::ambientScaled:
            lit += {ambient * (parts.lowShare - 1.0), ambient * (parts.highShare - 1.0)};
            return lit;
        case ShadowArithmetic::specularUnshadowed:
            lit = parts.litDiffuse;
            lit += parts.fullSpecular;
            return lit;
        case ShadowArithmetic::specularIfAny:
            lit = parts.litDiffuse;
            lit += decided(parts.fullSpecular, parts.lowShare > 1e-9, parts.highShare > 1e-9);
            return lit;
        case ShadowArithmetic::diffuseUnshadowed:
            lit = parts.fullDiffuse;
            lit += parts.litSpecular;
            return lit;
        case ShadowArithmetic::litIfAll:
            return decided(full, parts.lowShare > kAll, parts.highShare > kAll);
        case ShadowArithmetic::litIfAny:
            return decided(full, parts.lowShare > 1e-9, parts.highShare > 1e-9);
        case ShadowArithmetic::litIfHalf:
            return decided(full, parts.lowShare > 0.5 + 1e-9, parts.highShare > 0.5 - 1e-9);
        case ShadowArithmetic::right:
        case ShadowArithmetic::ambientForEachLight:
        case ShadowArithmetic::endless:
            break;
    }
    return lit;
}

}  // namespace

ColourRGB ambientPart(const PointLog& point, const SceneDescription& scene) {
    return materialOf(scene, point.point.object).colour * scene.ambientLighting;
}

ColourRGB unshadowed(const PointLog& point, const SceneDescription& scene, std::size_t light,
                     bool viewerIsEye) {
    const ShadowReading reading{Phong::central, viewerIsEye, false, false};
    const raytracer::RenderSettings settings;
    const Setting at{materialOf(scene, point.point.object),
                     scene.pointLights[light],
                     point,
                     settings,
                     reading,
                     false};
    const SampleTerms terms = centralTerms(at);
    return terms.diffuse.high + terms.specular.high;
}

// Directions and distances may be computed from the point or from the start of the rays, which
// differ by the shadow bias: the relative change of a term is at most (2 + alpha) bias / distance
// for each of L, V and the falloff. Single precision adds about 1e-5.
ColourRGB toleranceAt(const PointLog& point, const SceneDescription& scene, bool viewerIsEye) {
    const raytracer::Material& material = materialOf(scene, point.point.object);
    double nearest = (point.point.viewer - point.point.position).magnitude();
    ColourRGB most = ambientPart(point, scene);
    for (std::size_t i = 0; i < scene.pointLights.size(); ++i) {
        const Vector3 towards = scene.pointLights[i].position() - point.point.position;
        nearest = std::min(nearest, towards.magnitude());
        most += unshadowed(point, scene, i, viewerIsEye);
    }
    const double share = 4.0 * (2.0 + material.phongAlpha) * biasOf(point) / nearest + 2e-5;
    return most * share + ColourRGB{1e-9};
}

bool fits(const PointLog& point, const SceneDescription& scene,
          const raytracer::RenderSettings& settings, const ShadowReading& reading,
          ShadowArithmetic arithmetic) {
    const ColourRGB ambient = ambientPart(point, scene);
    const bool again = arithmetic == ShadowArithmetic::ambientForEachLight;
    const ColourRGB once = ambient * (again ? static_cast<double>(scene.pointLights.size()) : 1.0);
    Range range{once, once};
    for (std::size_t i = 0; i < scene.pointLights.size(); ++i) {
        const Setting at{
            materialOf(scene, point.point.object),  scene.pointLights[i], point, settings, reading,
            arithmetic == ShadowArithmetic::endless};
        range += addedBy(partsOf(at, point.lines[i]), ambient, arithmetic);
    }
    const ColourRGB slack = toleranceAt(point, scene, reading.viewerIsEye);
    const ColourRGB& seen = point.colour;
    return seen.r >= range.low.r - slack.r && seen.r <= range.high.r + slack.r &&
           seen.g >= range.low.g - slack.g && seen.g <= range.high.g + slack.g &&
           seen.b >= range.low.b - slack.b && seen.b <= range.high.b + slack.b;
}

FitCount countFits(const ShadowLog& log, const ShadowReading& reading,
                   ShadowArithmetic arithmetic) {
    FitCount count;
    for (const PointLog& point : log.points) {
        ++count.points;
        if (fits(point, log.scene(), log.settings(), reading, arithmetic)) ++count.fitting;
    }
    return count;
}

std::vector<ShadowReading> acceptedShadowReadings() {
    std::vector<ShadowReading> readings;
    // The last two allow the widest intervals, so they are tried last.
    for (const Phong phong :
         {Phong::central, Phong::perSampleDirection, Phong::centralFalloff, Phong::perSample})
        for (const bool viewerIsEye : {false, true})
            for (const bool withoutCentral : {false, true})
                readings.push_back({phong, viewerIsEye, withoutCentral, false});
    for (const Phong phong : {Phong::central, Phong::perSampleDirection})
        for (const bool viewerIsEye : {false, true})
            readings.push_back({phong, viewerIsEye, false, true});
    return readings;
}

}  // namespace ticker::tasks
