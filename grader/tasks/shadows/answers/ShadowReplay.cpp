#include <grader/tasks/shadows/answers/LightParts.h>
#include <grader/tasks/shadows/answers/ShadowReplay.h>

#include <algorithm>
#include <cmath>

namespace ticker::tasks {
namespace {

using Phong = ShadowReading::Phong;
using Terms = ShadowReading::Terms;
using raytracer::PointLight;
using raytracer::SceneDescription;

Range difference(const Range& whole, const Range& part) {
    return {whole.low - part.high, whole.high - part.low};
}

// The light under an all-or-nothing rule. Since the share of the rays may be an interval, the
// result is all of the light, none of it, or an interval from none to all.
Range decided(const Range& full, bool surely, bool possibly) {
    return {surely ? full.low : ColourRGB{}, possibly ? full.high : ColourRGB{}};
}

// The light of the rays that arrive, divided by their number. If none surely does, the least number
// is one ray.
Range meanOver(const LightParts& parts, const Range& lit) {
    if (!(parts.highShare > 0.0)) return {};
    const double least = std::max(parts.lowShare, parts.ray);
    return {parts.lowShare > 0.0 ? lit.low * (1.0 / parts.highShare) : ColourRGB{},
            lit.high * (1.0 / least)};
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
        case ShadowArithmetic::meanOverArrived:
            return meanOver(parts, lit);
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
    const ShadowReading reading{Phong::central, viewerIsEye, false, {}};
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

bool allFit(const ShadowLog& log, const ShadowReading& reading, ShadowArithmetic arithmetic) {
    return std::ranges::all_of(log.points, [&](const PointLog& point) {
        return fits(point, log.scene(), log.settings(), reading, arithmetic);
    });
}

std::vector<ShadowReading> acceptedShadowReadings() {
    std::vector<ShadowReading> readings;
    // Readings that allow wider intervals, or that few choose, are tried later.
    struct Rays {
        Terms terms;
        bool specularFirst;
    };
    for (const Rays rays :
         {Rays{Terms::together, false}, Rays{Terms::halves, false}, Rays{Terms::inTurns, false},
          Rays{Terms::halves, true}, Rays{Terms::inTurns, true}})
        for (const Phong phong :
             {Phong::central, Phong::perSampleDirection, Phong::centralFalloff, Phong::perSample})
            for (const bool viewerIsEye : {false, true})
                for (const bool withoutCentral : {false, true})
                    readings.push_back({.phong = phong,
                                        .viewerIsEye = viewerIsEye,
                                        .withoutCentral = withoutCentral,
                                        .terms = rays.terms,
                                        .specularFirst = rays.specularFirst});
    return readings;
}

bool fitsAnyReading(const ShadowLog& log) {
    return std::ranges::any_of(acceptedShadowReadings(), [&](const ShadowReading& reading) {
        return allFit(log, reading, ShadowArithmetic::right);
    });
}

}  // namespace ticker::tasks
