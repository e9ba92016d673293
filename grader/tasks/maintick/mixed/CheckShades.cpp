#include <grader/tasks/maintick/LightFindings.h>
#include <grader/tasks/maintick/mixed/MixedChecks.h>
#include <grader/tasks/maintick/mixed/PointTraits.h>
#include <grader/tasks/support/Traits.h>

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <variant>

namespace ticker::tasks::maintick {
namespace {

constexpr std::size_t kAsksOfShade = 6;

/// One light of a point, hidden or not.
struct Unit {
    const MixedShade* shade;
    const Way* way;

    [[nodiscard]] const LitSetup& alone() const { return shade->point.alone; }
    [[nodiscard]] const raytracer::PointLight& light() const {
        return alone().scene.pointLights[way->light];
    }
    [[nodiscard]] const raytracer::Material& own() const { return ownMaterialOf(alone()); }
    [[nodiscard]] std::size_t objects() const {
        return shade->point.scene.spheres.size() + shade->point.scene.planes.size();
    }
    [[nodiscard]] bool isHiddenBy(auto&& fits) const {
        return way->blocker && fits(tasks::materialOf(shade->point.scene, *way->blocker));
    }
    [[nodiscard]] bool isHiddenByPlane() const {
        return way->blocker &&
               static_cast<std::size_t>(*way->blocker) >= shade->point.scene.spheres.size();
    }
};

using raytracer::Material;

constexpr Trait<Unit> kWayTraits[] = {
    {"a blocker of reflectivity 1",
     [](const Unit& u) {
         return u.isHiddenBy([](const Material& m) { return m.reflectivity == 1.0; });
     }},
    {"a blocker of reflectivity 0",
     [](const Unit& u) {
         return u.isHiddenBy([](const Material& m) { return m.reflectivity == 0.0; });
     }},
    {"a black blocker",
     [](const Unit& u) {
         return u.isHiddenBy([](const Material& m) { return isBlack(m.colour); });
     }},
    {"a blocker that is not black",
     [](const Unit& u) {
         return u.isHiddenBy([](const Material& m) { return !isBlack(m.colour); });
     }},
    {"a plane before the light", [](const Unit& u) { return u.isHiddenByPlane(); }},
    {"a light nearer than 1",
     [](const Unit& u) { return distanceOf(u.alone(), u.light()) < kLightNear; }},
    {"a light farther away than 15",
     [](const Unit& u) { return distanceOf(u.alone(), u.light()) > kLightFar; }},
    {"faint light (less than 1/255 arrives)",
     [](const Unit& u) { return isFaint(u.alone(), u.light()); }},
    {"a light of one channel", [](const Unit& u) { return hasBlackChannel(u.light().colour()); }},
    {"a light low above the surface", [](const Unit& u) { return isLow(u.alone(), u.light()); }},
    {"a second light or a later one", [](const Unit& u) { return u.way->light > 0; }},
    {"a fourth light or a later one", [](const Unit& u) { return u.way->light > 2; }},
    {"a black surface", [](const Unit& u) { return isBlack(u.own().colour); }},
    {"a surface of reflectivity 1", [](const Unit& u) { return u.own().reflectivity == 1.0; }},
    {"a surface of reflectivity 0", [](const Unit& u) { return u.own().reflectivity == 0.0; }},
    {"a surface of phongKD 0", [](const Unit& u) { return u.own().phongKD == 0.0; }},
    {"a surface of phongKS 0", [](const Unit& u) { return u.own().phongKS == 0.0; }},
    {"a point of a plane", [](const Unit& u) { return u.shade->point.isOnPlane; }},
    {"a point behind the camera (z below 0)", [](const Unit& u) { return u.alone().P.z < 0.0; }},
    {"a point far from the origin",
     [](const Unit& u) { return u.alone().P.magnitude() > kPlaceFar; }},
    {"a scene without ambient light",
     [](const Unit& u) { return isBlack(u.alone().scene.ambientLighting); }},
    {"a scene of more than four objects", [](const Unit& u) { return u.objects() > 4; }},
    {"a light that nothing hides", [](const Unit& u) { return !u.way->blocker; }},
};

struct SeenShade {
    ColourRGB given;
    ColourRGB expected;
    bool isWrong = false;
    std::optional<std::uint32_t> wrong = {};  ///< bits of the lights that explain `given`
};

/// The smallest set of lights that explains the given colour if each of them is wrong: lit where it
/// is hidden, or dark where it is not. Empty if no set does.
std::optional<std::uint32_t> wrongLights(const MixedShade& shade, const ColourRGB& given) {
    std::uint32_t front = 0;
    std::uint32_t free = 0;
    for (const Way& way : shade.ways) {
        front |= 1U << way.light;
        if (!way.blocker) free |= 1U << way.light;
    }
    std::optional<std::uint32_t> best;
    for (std::uint32_t bits = front; bits != 0; bits = (bits - 1) & front)
        if (isNear(given, phong(withLights(shade.point.alone, free ^ bits))) &&
            (!best || std::popcount(bits) < std::popcount(*best)))
            best = bits;
    return best;
}

SeenShade seenOf(const MixedShade& shade, std::span<const probe::Answer> answers) {
    const auto colour = [&](std::size_t k) {
        return std::get<probe::IlluminateAnswer>(answers[k]).colours.at(0);
    };
    SeenShade seen{colour(0), colour(1)};
    // A mistake of M2 can overflow, as where a vector that is not normalised goes to a high power.
    if (!std::isfinite(largestChannel(seen.expected))) return seen;
    // Code that casts its shadow rays from the light does not light floating points.
    const bool isUnlit = isNear(colour(1), colour(5));
    if (isUnlit && isNear(seen.given, colour(4))) return seen;
    seen.isWrong = !isNear(seen.given, seen.expected) && !isNear(seen.given, colour(2)) &&
                   !isNear(seen.given, colour(3));
    if (seen.isWrong) seen.wrong = wrongLights(shade, seen.given);
    return seen;
}

/// For each light in front of a surface, whether it is wrong. If the colour of a wrong point does
/// not show which of its lights is wrong, all of them count as wrong.
struct Units {
    std::vector<Unit> units = {};
    std::vector<bool> isWrong = {};
    std::vector<SeenShade> seen = {};

    void add(const MixedShade& shade, const SeenShade& of) {
        for (const Way& way : shade.ways) {
            units.push_back({&shade, &way});
            isWrong.push_back(of.isWrong && (of.wrong.value_or(~0U) >> way.light & 1U) != 0);
            seen.push_back(of);
        }
    }
};

std::string describe(const Unit& unit, const SeenShade& seen) {
    const std::string traits = wordsOf(kWayTraits, unit);
    return fmt::format(
        "illuminate was asked about P = {} with N = {} in a scene of {} objects. Light {} of {}, "
        "at {}, is {}hidden{}{}{}. Expected {}, as without the lights that are hidden, got {}.",
        words(unit.alone().P), words(unit.alone().N), unit.objects(), unit.way->light + 1,
        unit.alone().scene.pointLights.size(), words(unit.light().position()),
        unit.way->blocker ? "" : "not ", traits.empty() ? "" : " (", traits,
        traits.empty() ? "" : ")", words(seen.expected), words(seen.given));
}

}  // namespace

void askMixedShades(const std::vector<MixedShade>& shades,
                    std::vector<probe::Question>& questions) {
    for (const MixedShade& shade : shades) {
        const LitSetup& alone = shade.point.alone;
        const auto inScene = [&](const raytracer::SceneDescription& scene, int object) {
            probe::IlluminateQuestion question;
            question.scene = scene;
            question.points.push_back({object, alone.P, alone.N, alone.O});
            questions.emplace_back(std::move(question));
        };
        const LitSetup dark = withoutHidden(shade);
        inScene(shade.point.scene, shade.point.object);
        inScene(dark.scene, 0);
        inScene(withHiddenOut(shade).scene, 0);
        inScene(withoutBlocked(shade).scene, 0);
        LitSetup onSurface = dark;
        layOnSphere(onSurface, 1.0, kRounding);
        inScene(onSurface.scene, 0);
        inScene(withLights(alone, 0).scene, 0);
    }
}

std::optional<Finding> checkMixedShades(const std::vector<MixedShade>& shades,
                                        std::span<const probe::Answer> answers) {
    Units all;
    for (std::size_t i = 0; i < shades.size(); ++i)
        all.add(shades[i], seenOf(shades[i], answers.subspan(kAsksOfShade * i, kAsksOfShade)));
    if (std::ranges::find(all.isWrong, true) == all.isWrong.end()) return std::nullopt;
    const std::size_t at = plainestWrong(kWayTraits, all.units, all.isWrong);
    const auto* common = commonTrait(kWayTraits, all.units, all.isWrong);
    return failure(
        kShadeWrong, describe(all.units[at], all.seen[at]),
        hintFor(common == nullptr ? nullptr : common->words, std::string{kShadeWrong.hint}));
}

}  // namespace ticker::tasks::maintick
