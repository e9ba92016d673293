#include <grader/tasks/maintick/MirrorFindings.h>
#include <grader/tasks/maintick/mixed/MixedChecks.h>
#include <grader/tasks/maintick/mixed/PointTraits.h>
#include <grader/tasks/support/Traits.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>
#include <variant>

namespace ticker::tasks::maintick {
namespace {

/// Heights above a lit surface, world units, at which its direct light is asked for: at the point,
/// which rounding may put on either side, and a thousandth above.
constexpr std::array kHeights{0.0, 1e-9, -1e-9, 1e-3};

std::size_t heightsOf(const MixedMirror& mirror) {
    return mirror.scene.pointLights.empty() ? 1 : kHeights.size();
}

/// One ray with a number of bounces left.
struct Cast {
    const MixedMirror* mirror;
    int bounces;

    /// The surface at which the chain of mirrors ends; null if the last mirrored ray hits nothing.
    [[nodiscard]] const MirrorLink* last() const {
        const auto& links = mirror->links;
        std::size_t i = 0;
        while (i < links.size() && static_cast<int>(i) < bounces && links[i].share != 0.0)
            ++i;
        return i < links.size() ? &links[i] : nullptr;
    }
    [[nodiscard]] bool endsAtShare(double share) const {
        return last() != nullptr && last()->share == share;
    }
    /// Whether one of the surfaces that mirror is like this.
    [[nodiscard]] bool anyMirror(auto&& fits) const {
        for (const MirrorLink& link : mirror->links) {
            if (&link == last()) return false;
            if (fits(tasks::materialOf(mirror->scene, link.object), link)) return true;
        }
        return false;
    }
};

using raytracer::Material;

constexpr Trait<Cast> kCastTraits[] = {
    {"a surface of reflectivity 1 with 0 bounces left",
     [](const Cast& c) { return c.endsAtShare(1.0); }},
    {"a surface of reflectivity 0", [](const Cast& c) { return c.endsAtShare(0.0); }},
    {"a mirrored ray that meets nothing", [](const Cast& c) { return c.last() == nullptr; }},
    {"a mirror of reflectivity 1",
     [](const Cast& c) {
         return c.anyMirror(
             [](const Material& m, const MirrorLink&) { return m.reflectivity == 1.0; });
     }},
    {"a mirror of reflectivity 0.97",
     [](const Cast& c) {
         return c.anyMirror(
             [](const Material& m, const MirrorLink&) { return m.reflectivity == 0.97; });
     }},
    {"a mirror of reflectivity 0.03",
     [](const Cast& c) {
         return c.anyMirror(
             [](const Material& m, const MirrorLink&) { return m.reflectivity == 0.03; });
     }},
    {"a black mirror",
     [](const Cast& c) {
         return c.anyMirror([](const Material& m, const MirrorLink&) { return isBlack(m.colour); });
     }},
    {"a mirror behind the camera (z below 0)",
     [](const Cast& c) {
         return c.anyMirror([](const Material&, const MirrorLink& l) { return l.P.z < 0.0; });
     }},
    {"a mirror far from the origin",
     [](const Cast& c) {
         return c.anyMirror(
             [](const Material&, const MirrorLink& l) { return l.P.magnitude() > kPlaceFar; });
     }},
    {"a mirror that is a plane",
     [](const Cast& c) {
         return c.anyMirror([&](const Material&, const MirrorLink& l) {
             return static_cast<std::size_t>(l.object) >= c.mirror->scene.spheres.size();
         });
     }},
    {"no point light", [](const Cast& c) { return c.mirror->scene.pointLights.empty(); }},
    {"a point light", [](const Cast& c) { return !c.mirror->scene.pointLights.empty(); }},
    {"no ambient light", [](const Cast& c) { return isBlack(c.mirror->scene.ambientLighting); }},
    {"more than one bounce", [](const Cast& c) { return c.bounces > 1; }},
    {"0 bounces left", [](const Cast& c) { return c.bounces == 0; }},
};

struct SeenMirror {
    ColourRGB given;
    ColourRGB expected;
    ColourRGB own;  ///< direct light of the first surface
    bool isWrong = false;
};

/// The direct light of each link; empty where it depends on rounding.
std::optional<std::vector<ColourRGB>> steadyDirect(const MixedMirror& mirror,
                                                   const std::vector<ColourRGB>& colours) {
    std::vector<ColourRGB> direct;
    const std::size_t heights = heightsOf(mirror);
    for (std::size_t i = 0; i < mirror.links.size(); ++i) {
        direct.push_back(colours.at(heights * i));
        for (std::size_t k = 1; k < heights; ++k)
            if (!isNear(colours.at(heights * i + k), direct.back(), kMirrorTolerance / 2.0))
                return std::nullopt;
    }
    return direct;
}

bool all(const std::vector<Cast>& casts, const std::vector<SeenMirror>& seen, auto&& fits) {
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i].isWrong && !fits(casts[i], seen[i])) return false;
    return true;
}

const FindingText& nameOf(const std::vector<Cast>& casts, const std::vector<SeenMirror>& seen) {
    for (std::size_t i = 0; i < seen.size(); ++i)
        if (seen[i].isWrong && casts[i].bounces == 0) return kMirrorBase;
    if (all(casts, seen,
            [](const Cast&, const SeenMirror& one) { return isNear(one.given, one.own); }))
        return kMirrorNone;
    if (all(casts, seen,
            [](const Cast& cast, const SeenMirror&) { return cast.last() == nullptr; }))
        return kMirrorBackground;
    return kMirrorWrong;
}

std::string describe(const Cast& cast, const SeenMirror& seen) {
    const std::string traits = wordsOf(kCastTraits, cast);
    return fmt::format(
        "trace was asked along the ray from {} in direction {} with {} bounce{} left{}{}: expected "
        "{}, got {}.",
        words(cast.mirror->ray.origin), words(cast.mirror->ray.direction), cast.bounces,
        cast.bounces == 1 ? "" : "s", traits.empty() ? "" : ", where there is ", traits,
        words(seen.expected), words(seen.given));
}

}  // namespace

void askMixedMirrors(const std::vector<MixedMirror>& mirrors,
                     std::vector<probe::Question>& questions) {
    for (const MixedMirror& mirror : mirrors) {
        probe::IlluminateQuestion direct;
        direct.scene = mirror.scene;
        for (const MirrorLink& link : mirror.links)
            for (std::size_t k = 0; k < heightsOf(mirror); ++k)
                direct.points.push_back(
                    {link.object, link.P + link.N * kHeights.at(k), link.N, link.O});
        probe::TraceQuestion traced;
        traced.scene = mirror.scene;
        for (int bounces = 0; bounces <= kMostMixedBounces; ++bounces)
            traced.rays.push_back({0, bounces, mirror.ray.origin, mirror.ray.direction});
        questions.emplace_back(std::move(direct));
        questions.emplace_back(std::move(traced));
    }
}

std::optional<Finding> checkMixedMirrors(const std::vector<MixedMirror>& mirrors,
                                         std::span<const probe::Answer> answers) {
    std::vector<Cast> casts;
    std::vector<SeenMirror> seen;
    std::vector<bool> isWrong;
    for (std::size_t m = 0; m < mirrors.size(); ++m) {
        const auto colours = [&](std::size_t k) -> const std::vector<ColourRGB>& {
            return std::get<probe::IlluminateAnswer>(answers[2 * m + k]).colours;
        };
        const auto direct = steadyDirect(mirrors[m], colours(0));
        if (!direct) continue;
        const double tolerance =
            mirrors[m].scene.pointLights.empty() ? kTolerance : kMirrorTolerance;
        for (int bounces = 0; bounces <= kMostMixedBounces; ++bounces) {
            const ColourRGB given = colours(1).at(static_cast<std::size_t>(bounces));
            const ColourRGB expected = alongLinks(mirrors[m], *direct, bounces);
            casts.push_back({&mirrors[m], bounces});
            isWrong.push_back(!isNear(given, expected, tolerance));
            seen.push_back({given, expected, direct->front(), isWrong.back()});
        }
    }
    if (std::ranges::find(isWrong, true) == isWrong.end()) return std::nullopt;
    const std::size_t at = plainestWrong(kCastTraits, casts, isWrong);
    const auto* common = commonTrait(kCastTraits, casts, isWrong);
    const FindingText& text = nameOf(casts, seen);
    return failure(text, describe(casts[at], seen[at]),
                   hintFor(common == nullptr ? nullptr : common->words, std::string{text.hint}));
}

}  // namespace ticker::tasks::maintick
