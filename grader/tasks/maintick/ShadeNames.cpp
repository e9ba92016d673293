#include <grader/tasks/maintick/LightFindings.h>
#include <grader/tasks/maintick/ShadeCases.h>

#include <algorithm>

namespace ticker::tasks::maintick {
namespace {

using Seen = std::vector<ShadeSeen>;
using Name = std::pair<const FindingText*, std::string>;

/// Whether `belongs` picks at least one case, and all that it picks show `what`.
template <class Belongs>
bool allShow(const Seen& seen, Shown what, const Belongs& belongs) {
    bool any = false;
    for (const ShadeSeen& one : seen) {
        if (!belongs(*one.asked)) continue;
        any = true;
        if (one.shown() != what) return false;
    }
    return any;
}

bool allShow(const Seen& seen, Shown what, Occluder place) {
    return allShow(seen, what, [&](const ShadeCase& shade) { return shade.place == place; });
}

bool isRight(const Seen& seen, Occluder place) {
    return allShow(seen, Shown::right, place);
}

bool anyIs(const Seen& seen, auto&& fits) {
    return std::any_of(seen.begin(), seen.end(), fits);
}

/// The name for code most of whose rays start near their point, but lead to no light.
std::optional<Name> nameOfAim(const Seen& seen) {
    constexpr double kTowards = 0.99;
    std::ptrdiff_t seenRays = 0;
    std::ptrdiff_t astray = 0;
    std::ptrdiff_t away = 0;
    for (const ShadeSeen& one : seen) {
        if (!one.aim) continue;
        ++seenRays;
        if (!(*one.aim >= kTowards)) ++astray;  // NaN as well
        if (*one.aim < -kTowards) ++away;
    }
    if (2 * away > seenRays)
        return Name{&kShadeWrong,
                    "The ray leaves away from the light: its direction is (light.position() - "
                    "P).normalised()."};
    if (2 * astray > seenRays)
        return Name{&kShadeWrong,
                    "The ray leaves in another direction than to the light: its direction is "
                    "(light.position() - P).normalised()."};
    return std::nullopt;
}

/// Whether, of the points with a logged ray, more than half have a start from `first` to `last`.
bool mostStart(const Seen& seen, RayStart first, RayStart last) {
    std::ptrdiff_t seenRays = 0;
    std::ptrdiff_t there = 0;
    for (const ShadeSeen& one : seen) {
        if (one.start == RayStart::unseen) continue;
        ++seenRays;
        if (one.start >= first && one.start <= last) ++there;
    }
    return 2 * there > seenRays;
}

/// The name for code most of whose rays start neither near their point nor near a light.
std::optional<Name> nameOfStart(const Seen& seen) {
    if (mostStart(seen, RayStart::alongNormal, RayStart::alongNormal))
        return Name{&kShadeBias,
                    "The ray starts far from P: start it at P + N * kShadowBias. N alone is 1 "
                    "long."};
    if (mostStart(seen, RayStart::alongNormal, RayStart::elsewhere))
        return Name{&kShadeWrong,
                    "The ray does not start at P: start it at P + N * kShadowBias, and look at "
                    "what the call hands to isShadowed, (scene, light, P, N)."};
    return std::nullopt;
}

/// Whether the only mistake is that hidden points are lit if rounding put them below their surface.
bool isLeak(const Seen& seen) {
    const auto isHiddenAndSunk = [](const ShadeCase& shade) {
        return shade.isShaded() && shade.isSunk;
    };
    return allShow(seen, Shown::lit, isHiddenAndSunk) &&
           allShow(seen, Shown::right,
                   [&](const ShadeCase& shade) { return !isHiddenAndSunk(shade); });
}

/// The name for code that lights all hidden points.
Name nameOfNoShadows(const Seen& seen) {
    if (allShow(seen, Shown::dark, [](const ShadeCase& shade) { return !shade.isShaded(); }))
        return {&kShadeInverted, ""};
    if (allShow(seen, Shown::dark, Occluder::beyond))
        return {&kShadeBeyond,
                "The comparison is the wrong way round: a hit that is nearer than the light "
                "shades."};
    return {&kShadeNone, ""};
}

constexpr const char* kFromLight =
    "The ray from the light meets the surface of P itself, at about the distance of P. Cast it the "
    "other way: Ray{P + N * kShadowBias, (light.position() - P).normalised()}.";

/// The name for code that is wrong where a sphere contains the point, the light or both, or where
/// the light grazes the surface.
std::optional<Name> nameOfSurrounded(const Seen& seen) {
    if (!isRight(seen, Occluder::aroundLight))
        return Name{&kShadeWrong,
                    "A sphere around the light hides it from every point outside: whatever the ray "
                    "meets before the light shades, whichever object that is."};
    if (!isRight(seen, Occluder::aroundPoint))
        return Name{&kShadeWrong,
                    "A sphere around P hides every light outside of it, though P is inside: "
                    "whatever the ray meets before the light shades, whichever object that is."};
    if (!isRight(seen, Occluder::aroundBoth))
        return Name{&kShadeBeyond,
                    "A sphere around both P and the light hides nothing: the ray meets it behind "
                    "the light. Compare the distance of the hit with that of the light."};
    if (!isRight(seen, Occluder::grazing))
        return Name{
            &kShadeWrong,
            "Low light is lost: where N.L is small but positive and nothing is in the way, "
            "the light arrives. Only a hit before the light makes shadow: leave the limit of "
            "N.L out, here or in illuminate. P + N * kShadowBias is enough against acne."};
    return std::nullopt;
}

/// Whether all cases with a light 95 world units away are right.
bool isRightOfFar(const Seen& seen) {
    return isRight(seen, Occluder::atPointOfFar) && isRight(seen, Occluder::atFarLight) &&
           isRight(seen, Occluder::beyondFarLight);
}

constexpr const char* kFarLight =
    "Right for near lights, wrong for one that is 95 away: whatever the ray meets before the light "
    "shades, however near to P or to the light that is, and nothing behind it does. Leave out a "
    "share of the distance as a tolerance (a hundredth is a whole unit there) and a limit of the "
    "distance: P + N * kShadowBias is enough against acne.";

/// The name for code that casts the usual shadow, about half-way to a light 3 units away, but is
/// wrong in other cases.
std::optional<Name> nameOfPlace(const Seen& seen) {
    if (anyIs(seen, [](const ShadeSeen& one) {
            return one.asked->place == Occluder::itself && one.shown() != Shown::right;
        }))
        return Name{&kShadeAcne,
                    mostStart(seen, RayStart::nearLight, RayStart::nearLight) ? kFromLight : ""};
    if (!isRight(seen, Occluder::near) && isRight(seen, Occluder::farBeyond) &&
        isRight(seen, Occluder::between))
        return Name{&kShadeBias, ""};
    if (allShow(seen, Shown::dark, Occluder::beyond) && isRight(seen, Occluder::close))
        return Name{&kShadeBeyond, ""};
    for (const Occluder place : {Occluder::farBeyond, Occluder::close, Occluder::between})
        if (!isRight(seen, place)) return Name{&kShadeDistance, ""};
    if (!isRight(seen, Occluder::near)) return Name{&kShadeBias, ""};
    if (!isRightOfFar(seen)) return Name{&kShadeDistance, kFarLight};
    if (!isRight(seen, Occluder::ofFirstLight) || !isRight(seen, Occluder::ofSecondLight))
        return Name{&kShadeLights, ""};
    if (!isRight(seen, Occluder::betweenLights))
        return Name{&kShadeLights,
                    "What hid one light decides nothing for the next: compare the distance of "
                    "every hit with that of the light, and remember no object and no answer."};
    if (!isRight(seen, Occluder::wall))
        return Name{&kShadeWrong,
                    "Planes cast shadows, too: whatever the ray meets before the light hides it."};
    if (!isRight(seen, Occluder::beforeAndBeyond))
        return Name{&kShadeWrong,
                    "What stands behind the light decides nothing: look at the other objects, too, "
                    "or take the nearest hit, scene.findClosestIntersection(ray)."};
    if (!isRight(seen, Occluder::ofFaintLight))
        return Name{&kShadeWrong,
                    "Faint lights cast shadows, too: cast the ray for every light, however little "
                    "it adds."};
    return nameOfSurrounded(seen);
}

Name nameOfColour(const Seen& seen, Occluder place) {
    const auto shows = [&](Shown what) {
        return anyIs(seen, [&](const ShadeSeen& one) {
            return one.shown() == what && one.asked->place == place;
        });
    };
    if (shows(Shown::black)) return {&kShadeAmbient, ""};
    if (shows(Shown::specular)) return {&kShadeSpecular, ""};
    if (shows(Shown::diffuse)) return {&kShadeDiffuse, ""};
    if (shows(Shown::ambientAgain))
        return {&kShadeWrong,
                "Ambient light is added more than once: it is there since before the loop over the "
                "lights, so that a light that is hidden adds nothing (continue)."};
    if (allShow(seen, Shown::lit, Occluder::before))
        return {&kShadeWrong,
                "What is hidden comes out lit. Look at four things: what the call hands to "
                "isShadowed (P, not O), the start P + N * kShadowBias, the direction to the light, "
                "and the comparison: a hit nearer than the light shades."};
    return {&kShadeWrong, ""};
}

/// Whether the colour is right but for ambient light, which is added once more, or once more for
/// each light.
bool hasAmbientAgain(const ShadeSeen& seen) {
    const raytracer::SceneDescription& scene = seen.asked->asked.scene;
    const ColourRGB ambient = scene.spheres[0].material.colour * scene.ambientLighting;
    const auto lights = static_cast<double>(scene.pointLights.size());
    return isNear(seen.given, seen.expected() + ambient) ||
           isNear(seen.given, seen.expected() + ambient * lights);
}

}  // namespace

ColourRGB ShadeSeen::expected() const {
    return asked->isShaded() ? dark : lit;
}

bool ShadeSeen::hasNoLight() const {
    return isNear(lit, dark) || isNear(lit, putOut);
}

Shown ShadeSeen::shown() const {
    if (isUnlit) return Shown::dark;
    const bool isDark = isNear(given, dark) || isNear(given, putOut);
    if (asked->isShaded() ? isDark : isNear(given, lit)) return Shown::right;
    if (isNear(given, lit)) return Shown::lit;
    if (isDark) return Shown::dark;
    if (isNear(given, ColourRGB{0.0})) return Shown::black;
    if (isNear(given, specular)) return Shown::specular;
    if (isNear(given, diffuse)) return Shown::diffuse;
    return hasAmbientAgain(*this) ? Shown::ambientAgain : Shown::other;
}

Name nameOf(const Seen& seen, const ShadeSeen& first) {
    if (auto name = nameOfAim(seen)) return *std::move(name);
    if (auto name = nameOfStart(seen)) return *std::move(name);
    if (isLeak(seen))
        return {&kShadeWrong,
                "Rounding puts P a little below its surface half of the time. From there the "
                "nearest hit is that surface, and what stands between goes unseen: start the ray "
                "at P + N * kShadowBias, so that every hit before the light counts."};
    if (allShow(seen, Shown::lit, [](const ShadeCase& shade) { return shade.isShaded(); }))
        return nameOfNoShadows(seen);
    if (isRight(seen, Occluder::before) || isRight(seen, Occluder::between))
        if (auto name = nameOfPlace(seen)) return *std::move(name);
    return nameOfColour(seen, first.asked->place);
}

}  // namespace ticker::tasks::maintick
