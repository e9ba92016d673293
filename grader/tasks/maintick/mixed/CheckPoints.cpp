#include <grader/tasks/maintick/LightFindings.h>
#include <grader/tasks/maintick/mixed/MixedChecks.h>
#include <grader/tasks/maintick/mixed/PointTraits.h>
#include <grader/tasks/support/Traits.h>

#include <fmt/core.h>

#include <utility>
#include <variant>

namespace ticker::tasks::maintick {
namespace {

using raytracer::PointLight;
using Setup = LitSetup;

constexpr Trait<Setup> kPointTraits[] = {
    {"no point light", [](const Setup& s) { return s.scene.pointLights.empty(); }},
    {"no ambient light", [](const Setup& s) { return isBlack(s.scene.ambientLighting); }},
    {"more than one point light", [](const Setup& s) { return s.scene.pointLights.size() > 1; }},
    {"six point lights", [](const Setup& s) { return s.scene.pointLights.size() == 6; }},
    {"a light nearer than 1",
     [](const Setup& s) {
         return anyLight(
             s, [](const auto& of, const auto& l) { return distanceOf(of, l) < kLightNear; });
     }},
    {"a light farther away than 15",
     [](const Setup& s) {
         return anyLight(
             s, [](const auto& of, const auto& l) { return distanceOf(of, l) > kLightFar; });
     }},
    {"faint light (less than 1/255 arrives)", [](const Setup& s) { return anyLight(s, isFaint); }},
    {"bright light (more than 2 arrives)",
     [](const Setup& s) {
         return anyLight(
             s, [](const auto& of, const auto& l) { return arrivingOf(of, l) > kArrivesBright; });
     }},
    {"a light of one channel",
     [](const Setup& s) {
         return anyLight(s, [](const auto&, const auto& l) { return hasBlackChannel(l.colour()); });
     }},
    {"a light behind the surface",
     [](const Setup& s) {
         return anyLight(s, [](const auto& of, const auto& l) { return facingOf(of, l) < 0.0; });
     }},
    {"a light low above the surface", [](const Setup& s) { return anyLight(s, isLow); }},
    {"a black surface", [](const Setup& s) { return isBlack(ownMaterialOf(s).colour); }},
    {"a surface that is black in one channel",
     [](const Setup& s) { return hasBlackChannel(ownMaterialOf(s).colour); }},
    {"a surface of phongKD 0", [](const Setup& s) { return ownMaterialOf(s).phongKD == 0.0; }},
    {"a surface of phongKD 2", [](const Setup& s) { return ownMaterialOf(s).phongKD == 2.0; }},
    {"a surface of phongKS 0", [](const Setup& s) { return ownMaterialOf(s).phongKS == 0.0; }},
    {"a surface of phongKS 1.4", [](const Setup& s) { return ownMaterialOf(s).phongKS == 1.4; }},
    {"a surface of phongAlpha 1",
     [](const Setup& s) { return ownMaterialOf(s).phongAlpha == 1.0; }},
    {"a surface of phongAlpha 2",
     [](const Setup& s) { return ownMaterialOf(s).phongAlpha == 2.0; }},
    {"a surface of phongAlpha 280",
     [](const Setup& s) { return ownMaterialOf(s).phongAlpha == 280.0; }},
    {"a surface of reflectivity 0",
     [](const Setup& s) { return ownMaterialOf(s).reflectivity == 0.0; }},
    {"a surface of reflectivity 1",
     [](const Setup& s) { return ownMaterialOf(s).reflectivity == 1.0; }},
    {"a point behind the camera (z below 0)", [](const Setup& s) { return s.P.z < 0.0; }},
    {"a viewer behind the camera (z below 0)", [](const Setup& s) { return s.O.z < 0.0; }},
    {"a point far from the origin", [](const Setup& s) { return s.P.magnitude() > kPlaceFar; }},
};

/// Whether the colour is right for a subset of the lights, as if the others were lost.
bool hasLostLights(const Setup& setup, const ColourRGB& given) {
    const std::uint32_t all = 1U << setup.scene.pointLights.size();
    for (std::uint32_t bits = 0; bits < all; ++bits)
        if (isNear(given, phong(withLights(setup, bits)))) return true;
    return false;
}

struct SeenPoint {
    ColourRGB given;
    bool isWrong = false;
};

/// Colours that the code gives for the floating point, with all lights, and for the point in its
/// scene.
struct Told {
    ColourRGB alone;
    ColourRGB inScene;
};

/// Whether all floating points are dark: code that casts its shadow rays from the light hits no
/// surface there.
bool isUnlitAlone(const std::vector<MixedPoint>& points, const std::vector<Told>& told) {
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!isNear(told[i].alone, phong(withLights(points[i].alone, 0)))) return false;
    return true;
}

SeenPoint seenOf(const MixedPoint& point, const Told& told, bool isUnlit) {
    const ColourRGB right = phong(point.alone);
    if (!isUnlit && !isNear(told.alone, right)) return {told.alone, true};
    if (isNear(told.inScene, right)) return {right, false};
    // A lost light is a mistake of M3.2: a shadow ray hit the point's own surface, or an object
    // beside the way.
    return {told.inScene, isUnlit || !hasLostLights(point.alone, told.inScene)};
}

/// The known mistake that explains all wrong answers. The right ones may not fit it, since the code
/// may make it only under a condition. Null if none fits, or if fewer than two answers are wrong.
const PhongMistake* mistakeOf(const std::vector<MixedPoint>& points,
                              const std::vector<SeenPoint>& seen) {
    std::vector<std::size_t> wrong;
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i].isWrong) wrong.push_back(i);
    if (wrong.size() < 2) return nullptr;
    const auto isRight = [&](std::size_t i, const PhongMistake* mistake) {
        return isNear(seen[wrong[i]].given, phong(points[wrong[i]].alone, mistake));
    };
    for (const PhongMistake& mistake : phongMistakes())
        if (mistake.finding != &kPhongUnlit && !firstWrong(wrong.size(), &mistake, isRight))
            return &mistake;
    return nullptr;
}

std::string describe(const MixedPoint& point, const SeenPoint& seen) {
    const Setup& s = point.alone;
    const std::string traits = wordsOf(kPointTraits, s);
    return fmt::format(
        "illuminate was asked about P = {} with N = {}, seen from O = {}, on a {} in a scene of {} "
        "objects{}{}: expected {}, got {}.",
        words(s.P), words(s.N), words(s.O), point.isOnPlane ? "plane" : "sphere",
        point.scene.spheres.size() + point.scene.planes.size(), traits.empty() ? "" : ", with ",
        traits, words(phong(s)), words(seen.given));
}

}  // namespace

void askMixedPoints(const std::vector<MixedPoint>& points,
                    std::vector<probe::Question>& questions) {
    for (const MixedPoint& point : points) {
        const LitSetup& alone = point.alone;
        questions.emplace_back(questionOf(alone));
        probe::IlluminateQuestion inScene;
        inScene.scene = point.scene;
        // Lights behind the surface add nothing, but the surface may shade the point.
        std::erase_if(inScene.scene.pointLights,
                      [&](const PointLight& light) { return facingOf(alone, light) < 0.0; });
        inScene.points.push_back({point.object, alone.P, alone.N, alone.O});
        questions.emplace_back(std::move(inScene));
    }
}

std::optional<Finding> checkMixedPoints(const std::vector<MixedPoint>& points,
                                        std::span<const probe::Answer> answers) {
    std::vector<SeenPoint> seen;
    std::vector<Setup> asked;
    std::vector<bool> isWrong;
    std::vector<Told> told;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto colour = [&](std::size_t k) {
            return std::get<probe::IlluminateAnswer>(answers[2 * i + k]).colours.at(0);
        };
        told.push_back({colour(0), colour(1)});
    }
    const bool isUnlit = isUnlitAlone(points, told);
    for (std::size_t i = 0; i < points.size(); ++i) {
        seen.push_back(seenOf(points[i], told[i], isUnlit));
        asked.push_back(points[i].alone);
        isWrong.push_back(seen.back().isWrong);
    }
    if (std::ranges::find(isWrong, true) == isWrong.end()) return std::nullopt;
    const std::size_t at = plainestWrong(kPointTraits, asked, isWrong);
    const auto* common = commonTrait(kPointTraits, asked, isWrong);
    const PhongMistake* known = mistakeOf(points, seen);
    const FindingText& text = known != nullptr ? *known->finding : kPhongWrong;
    const bool hasOwnHint = known != nullptr && known->hint[0] != '\0';
    return failure(text, describe(points[at], seen[at]),
                   hintFor(common == nullptr ? nullptr : common->words,
                           hasOwnHint ? known->hint : std::string{text.hint}));
}

}  // namespace ticker::tasks::maintick
