#include <grader/tasks/shadows/ShadowFindings.h>
#include <grader/tasks/shadows/answers/KnownColours.h>
#include <grader/tasks/shadows/answers/LightParts.h>
#include <grader/tasks/shadows/answers/ShadowAims.h>
#include <grader/tasks/support/FindingOrder.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

namespace ticker::tasks {
namespace {

struct NamedArithmetic {
    ShadowArithmetic arithmetic;
    const FindingText* text;
    const char* seen;
    const char* hint = nullptr;  ///< instead of the finding's own
};

constexpr std::array kMistakes{
    NamedArithmetic{ShadowArithmetic::inverted, &kShadowInverted,
                    "Points that no ray's way is blocked from were expected to be lit; lit and "
                    "shadowed are exchanged."},
    NamedArithmetic{ShadowArithmetic::litIfAll, &kShadowAllOrNothing,
                    "At the edge of a shadow a fraction of the light was expected; there is all of "
                    "it where every ray arrives and none elsewhere."},
    NamedArithmetic{ShadowArithmetic::litIfAny, &kShadowAllOrNothing,
                    "At the edge of a shadow a fraction of the light was expected; there is all of "
                    "it as soon as one ray arrives.",
                    "The share must be a fraction: the number of rays that arrive, divided by the "
                    "number of all rays that are cast, the blocked ones as well. A sum over the "
                    "rays is divided by settings().shadowRayCount, not by the number of those that "
                    "arrive; and a yes or no is no number of rays."},
    NamedArithmetic{ShadowArithmetic::litIfHalf, &kShadowAllOrNothing,
                    "At the edge of a shadow a fraction of the light was expected; there is all of "
                    "it where more than half of the rays arrive and none elsewhere."},
    NamedArithmetic{
        ShadowArithmetic::ambientScaled, &kShadowAmbientScaled,
        "In shadow the ambient light was expected to stay; it is scaled like the rest."},
    NamedArithmetic{ShadowArithmetic::specularUnshadowed, &kShadowSpecularUnshadowed,
                    "In shadow no highlight was expected; the specular term is there in full."},
    NamedArithmetic{ShadowArithmetic::specularIfAny, &kShadowSpecularUnshadowed,
                    "At the edge of a shadow a fraction of the highlight was expected; it is there "
                    "in full as soon as one ray arrives."},
    NamedArithmetic{ShadowArithmetic::diffuseUnshadowed, &kShadowDiffuseUnshadowed,
                    "In shadow no diffuse light was expected; the diffuse term is there in full."},
    NamedArithmetic{ShadowArithmetic::meanOverArrived, &kShadowAllOrNothing,
                    "At the edge of a shadow a fraction of the light was expected; the sum over "
                    "the rays is divided by the number of rays that arrive, so that a point which "
                    "sees any of the light has all of it.",
                    "Divide the sum by the number of all rays that are cast, the blocked ones as "
                    "well: settings().shadowRayCount, not the number of those that arrive."}};

// Colour of a point that lies in full light or full shadow of every light, from geometry; empty for
// other points.
std::optional<ColourRGB> knownColour(const PointLog& point,
                                     const raytracer::SceneDescription& scene, bool viewerIsEye) {
    ColourRGB expected = ambientPart(point, scene);
    for (std::size_t i = 0; i < point.zones.size(); ++i) {
        if (point.zones[i] == Zone::penumbra) return std::nullopt;
        if (point.zones[i] == Zone::lit) expected += unshadowed(point, scene, i, viewerIsEye);
    }
    return expected;
}

ColourRGB inFullLightSeen(const PointLog& point, const raytracer::SceneDescription& scene,
                          bool viewerIsEye) {
    ColourRGB colour = ambientPart(point, scene);
    for (std::size_t i = 0; i < scene.pointLights.size(); ++i)
        colour += unshadowed(point, scene, i, viewerIsEye);
    return colour;
}

// All that one light may give if each ray has a term of its own: the light of single aims, each in
// its direction or the centre's, with its distance or the centre's. A mean lies between these.
Range overAims(const PointLog& point, const ShadowLog& log, const raytracer::PointLight& light,
               bool viewerIsEye) {
    constexpr int kAims = 256;
    const ShadowReading reading{ShadowReading::Phong::central, viewerIsEye, false, {}};
    const Setting at{
        materialOf(log.scene(), point.point.object), light, point, log.settings(), reading, false};
    const Vector3 centre = light.position() - point.point.position;
    const ColourRGB central = at.terms(centre.normalised(), centre.magnitude()).sum();
    Range range{central, central};
    for (const Vector3& place : aimsOf(AimShape::surface, kAims)) {
        const Vector3 towards = centre + place * log.settings().lightSize;
        const double distance = towards.magnitude();
        const double falloff = centre.dot(centre) / (distance * distance);
        const ColourRGB own = at.terms(towards / distance, centre.magnitude()).sum();
        for (const ColourRGB& one : {own, own * falloff, central * falloff})
            for (const auto channel : {&ColourRGB::r, &ColourRGB::g, &ColourRGB::b}) {
                range.low.*channel = std::min(range.low.*channel, one.*channel);
                range.high.*channel = std::max(range.high.*channel, one.*channel);
            }
    }
    return range;
}

bool isBetween(const PointLog& point, const ShadowLog& log, bool viewerIsEye,
               const ColourRGB& slack) {
    const ColourRGB ambient = ambientPart(point, log.scene());
    Range range{ambient, ambient};
    for (std::size_t i = 0; i < point.zones.size(); ++i)
        if (point.zones[i] == Zone::lit)
            range += overAims(point, log, log.scene().pointLights[i], viewerIsEye);
    const auto within = [&](double ColourRGB::*channel) {
        return point.colour.*channel >= range.low.*channel - slack.*channel &&
               point.colour.*channel <= range.high.*channel + slack.*channel;
    };
    return within(&ColourRGB::r) && within(&ColourRGB::g) && within(&ColourRGB::b);
}

}  // namespace

ColourRGB inFullLight(const PointLog& point, const raytracer::SceneDescription& scene) {
    return inFullLightSeen(point, scene, false);
}

bool near(const ColourRGB& a, const ColourRGB& b, const ColourRGB& slack) {
    return std::abs(a.r - b.r) <= slack.r && std::abs(a.g - b.g) <= slack.g &&
           std::abs(a.b - b.b) <= slack.b;
}

bool isNearKnown(const PointLog& point, const ShadowLog& log, bool viewerIsEye) {
    const std::optional<ColourRGB> expected = knownColour(point, log.scene(), viewerIsEye);
    if (!expected) return true;
    double nearest = 1e9;
    for (const raytracer::PointLight& light : log.scene().pointLights)
        nearest = std::min(nearest, (light.position() - point.point.position).magnitude());
    constexpr double kSlack = 0.05;
    const ColourRGB rounding{1e-6};  // of channels that have no light
    const double share = kSlack + 2.0 * log.settings().lightSize / nearest;
    const ColourRGB most = inFullLightSeen(point, log.scene(), viewerIsEye);
    return near(point.colour, *expected, most * share + rounding) ||
           isBetween(point, log, viewerIsEye, most * kSlack + rounding);
}

bool allNearKnown(const std::vector<const ShadowLog*>& logs, bool viewerIsEye) {
    for (const ShadowLog* log : logs)
        for (const PointLog& point : log->points)
            if (!isNearKnown(point, *log, viewerIsEye)) return false;
    return true;
}

Finding findingOf(ShadowArithmetic arithmetic) {
    const auto* mistake =
        std::find_if(kMistakes.begin(), kMistakes.end(),
                     [&](const NamedArithmetic& known) { return known.arithmetic == arithmetic; });
    Finding finding = distributedFinding(*mistake->text, Severity::fail, mistake->seen);
    if (mistake->hint) finding.hint = mistake->hint;
    return finding;
}

const std::vector<ShadowArithmetic>& namedMistakes() {
    static const std::vector<ShadowArithmetic> all = [] {
        std::vector<ShadowArithmetic> some;
        std::transform(kMistakes.begin(), kMistakes.end(), std::back_inserter(some),
                       [](const NamedArithmetic& mistake) { return mistake.arithmetic; });
        return some;
    }();
    return all;
}

Finding lightsLostBehind() {
    Finding finding = distributedFinding(
        kShadowLightsMixed, Severity::fail,
        "Where one of three lights shines on the back of the surface, the two others were expected "
        "to light it all the same; they do not, or not both.");
    finding.hint =
        "A light behind the surface adds nothing: go on with the next one (continue), and leave "
        "neither the loop (break) nor illuminate (return).";
    return finding;
}

Finding ambientForEachLight() {
    Finding finding = distributedFinding(
        kShadowLightsMixed, Severity::fail,
        "With one light the colours are right; with several lights the ambient light was expected "
        "once, and it is there once for each light.");
    finding.hint =
        "The ambient light belongs to the scene, not to a light: add it once, before the loop over "
        "the lights, and not times their number.";
    finding.section = "Soft shadows (T2.1), step 3";
    return finding;
}

Finding oneObjectCasts() {
    Finding finding = distributedFinding(
        kShadowLightsMixed, Severity::fail,
        "With one sphere in the scene its shadow is right; with two spheres the shadow of one is "
        "there, and the other casts none.");
    finding.hint =
        "Every object of the scene may stand in the way, not the first alone: ask "
        "scene.findClosestIntersection(shadowRay), which looks at all of them.";
    finding.section = "Soft shadows (T2.1), step 1";
    return finding;
}

Finding hitsMistaken() {
    Finding finding = distributedFinding(
        kShadowWrong, Severity::fail,
        "With one object on the way of the rays the colours are right; where two spheres stand one "
        "behind the other before the light, and others behind the light in the same line, they are "
        "not.");
    finding.hint =
        "In a loop over the objects keep the nearest hit, not the first or the last one that is "
        "found, before you compare it with the light's distance; and count a ray once, however "
        "many objects it hits. scene.findClosestIntersection(shadowRay) does both.";
    finding.section = "Soft shadows (T2.1), step 1";
    return finding;
}

Finding nearLightMissed() {
    Finding finding = distributedFinding(
        kShadowWrong, Severity::fail,
        "Objects far from the light cast the shadows that were expected; one that stands close "
        "before the light, just outside of its ball, was expected to keep all of its light away, "
        "and does not.");
    finding.hint =
        "A hit stops a shadow ray wherever it lies before the point that the ray aims at, however "
        "close to the light: compare occluder->distance with (target - start).magnitude() as it "
        "is, without a factor and with nothing taken from it.";
    finding.section = "Soft shadows (T2.1), step 1";
    return finding;
}

Finding planesCastNothing() {
    Finding finding = distributedFinding(
        kShadowWrong, Severity::fail,
        "Spheres cast the shadows that were expected; a plane between a point and the light does "
        "not.");
    finding.hint =
        "Whatever a shadow ray hits before the light stops it, planes as well: ask "
        "scene.findClosestIntersection(shadowRay), which looks at every object, not the first "
        "object alone nor the spheres alone, and do not ask what kind of object it hit.";
    return finding;
}

}  // namespace ticker::tasks
