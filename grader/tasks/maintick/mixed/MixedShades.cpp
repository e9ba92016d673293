#include <grader/tasks/maintick/mixed/MixedShades.h>

#include <grader/tasks/maintick/TraceModel.h>
#include <grader/tasks/maintick/mixed/Edges.h>

#include <algorithm>
#include <utility>

namespace ticker::tasks::maintick {
namespace {

using raytracer::PlaneDescription;
using raytracer::PointLight;
using raytracer::SphereDescription;

/// What is put near the way to a light.
enum class Role : std::uint8_t { hides, hidesBehindAnother, beyond, beside, nothing };

struct Things {
    std::vector<SphereDescription> spheres;
    std::vector<PlaneDescription> planes;
};

class Occluders {
public:
    explicit Occluders(Draw& draw)
        : draw_(&draw),
          hiders_(draw),
          others_(draw),
          roles_(draw, {Role::hides, Role::hides, Role::hidesBehindAnother, Role::beyond,
                        Role::beside, Role::nothing}),
          isPlane_(draw, {true, false}) {}

    [[nodiscard]] Things around(const LitSetup& setup) {
        Things things;
        for (const PointLight& light : setup.scene.pointLights)
            if (facingOf(setup, light) > 0.0) add(things, setup, light, roles_.deal());
        for (int more = draw_->whole(0, 2); more > 0; --more)
            addAnywhere(things, setup);
        return things;
    }

private:
    void addAnywhere(Things& things, const LitSetup& setup) {
        const Vector3 way = draw_->direction() * draw_->between(0.5, 12.0);
        const raytracer::Material material = others_.deal();
        if (isPlane_.deal()) {
            things.planes.push_back({setup.P + way, draw_->direction(), material});
        } else {
            const double radius = draw_->between(0.05, 0.4) * way.magnitude();
            things.spheres.push_back({setup.P + way, radius, material, nullptr});
        }
    }

    void add(Things& things, const LitSetup& setup, const PointLight& light, Role role) {
        if (role == Role::nothing) return;
        const Ray way = wayTo(setup, light);
        const double distance = (light.position() - setup.P).magnitude();
        const bool isBeyond = role == Role::beyond;
        if (role != Role::beside && isPlane_.deal()) {
            const double along = isBeyond ? distance * draw_->between(1.1, 2.0) + 0.1
                                          : distance * draw_->between(0.3, 0.7);
            const Vector3 normal = draw_->directionAround(way.direction, 0.5);
            const Vector3 aside =
                perpendicularsOf(normal).first * (draw_->between(-2.0, 2.0) * distance);
            const bool isTurned = draw_->whole(0, 1) == 1;
            things.planes.push_back(
                {way.evaluateAt(along) + aside, isTurned ? -normal : normal, materialOf(role)});
        } else {
            addBall(things, way, distance, role);
        }
        if (role == Role::hidesBehindAnother) addBall(things, way, distance, Role::hides);
    }

    void addBall(Things& things, const Ray& way, double distance, Role role) {
        constexpr double kSmallest = 0.03;
        constexpr double kApart = 0.03;
        const double radius =
            std::max(kSmallest, draw_->between(0.03, 0.25) * std::min(distance, 10.0));
        const double along =
            role == Role::beyond
                ? distance + radius + kApart + draw_->between(0.0, 0.5) * distance
                : draw_->between(radius + kApart,
                                 std::max(radius + kApart, distance - radius - kApart));
        const double aside = role == Role::beside ? radius + draw_->between(0.015, 0.1)
                                                  : draw_->between(0.0, 0.5) * radius;
        const Vector3 across =
            perpendicularsOf(way.direction).first.cross(way.direction).normalised();
        const Vector3 side = (across * draw_->between(-1.0, 1.0) +
                              perpendicularsOf(way.direction).first * draw_->between(0.1, 1.0))
                                 .normalised();
        things.spheres.push_back(
            {way.evaluateAt(along) + side * aside, radius, materialOf(role), nullptr});
    }

    /// Objects that hide a light have a deck of their own, so that every kind of material hides
    /// one.
    raytracer::Material materialOf(Role role) {
        return role == Role::hides || role == Role::hidesBehindAnother ? hiders_.deal()
                                                                       : others_.deal();
    }

    Draw* draw_;
    MixedMaterials hiders_;
    MixedMaterials others_;
    Deck<Role> roles_;
    Deck<bool> isPlane_;
};

/// The ways to the lights in front of the surface; empty if one passes too near to an edge.
std::optional<std::vector<Way>> waysOf(const MixedPoint& point) {
    std::vector<Way> ways;
    const auto& lights = point.scene.pointLights;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        if (facingOf(point.alone, lights[i]) < 0.0) continue;
        const Ray way = wayTo(point.alone, lights[i]);
        const double distance = (lights[i].position() - point.alone.P).magnitude();
        const Sight sight = sightOf(point.scene, way, distance, point.object);
        if (sight == Sight::unsure) return std::nullopt;
        ways.push_back({i, {}});
        // From a little above the surface, so that the ray does not meet it.
        const Ray above{way.origin + point.alone.N * 1e-4, way.direction};
        if (sight == Sight::blocked) ways.back().blocker = nearestOn(point.scene, above)->object;
    }
    return ways;
}

/// Bits of the lights that arrive at the point.
std::uint32_t bitsOfFree(const MixedShade& shade) {
    std::uint32_t bits = 0;
    for (const Way& way : shade.ways)
        if (!way.blocker) bits |= 1U << way.light;
    return bits;
}

}  // namespace

std::vector<MixedShade> drawMixedShades(std::uint64_t seed) {
    constexpr std::size_t kShades = 72;
    constexpr int kMostTries = 60;
    Draw draw{seed, 110};
    MixedPoints points{draw, {1, 1, 2, 3, 6, 6}, true};
    Occluders occluders{draw};
    std::vector<MixedShade> shades;
    while (shades.size() < kShades) {
        const MixedPoint point = points.deal();
        for (int tries = 0; tries < kMostTries; ++tries) {
            MixedShade shade{point, {}};
            Things things = occluders.around(point.alone);
            assemble(draw, shade.point, std::move(things.spheres), std::move(things.planes));
            auto ways = waysOf(shade.point);
            if (!ways || ways->empty()) continue;
            shade.ways = *std::move(ways);
            shades.push_back(std::move(shade));
            break;
        }
    }
    return shades;
}

LitSetup withLights(const LitSetup& setup, std::uint32_t bits) {
    LitSetup some = setup;
    some.scene.pointLights.clear();
    for (std::size_t i = 0; i < setup.scene.pointLights.size(); ++i)
        if ((bits >> i & 1U) != 0) some.scene.pointLights.push_back(setup.scene.pointLights[i]);
    return some;
}

LitSetup withoutHidden(const MixedShade& shade) {
    return withLights(shade.point.alone, bitsOfFree(shade));
}

LitSetup withoutBlocked(const MixedShade& shade) {
    std::uint32_t bits = ~0U;
    for (const Way& way : shade.ways)
        if (way.blocker) bits &= ~(1U << way.light);
    return withLights(shade.point.alone, bits);
}

LitSetup withHiddenOut(const MixedShade& shade) {
    LitSetup setup = shade.point.alone;
    const std::uint32_t free = bitsOfFree(shade);
    for (std::size_t i = 0; i < setup.scene.pointLights.size(); ++i) {
        PointLight& light = setup.scene.pointLights[i];
        if ((free >> i & 1U) == 0) light = {light.position(), light.colour(), 0.0};
    }
    return setup;
}

}  // namespace ticker::tasks::maintick
