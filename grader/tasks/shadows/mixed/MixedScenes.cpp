#include <grader/tasks/shadows/mixed/ClearLights.h>
#include <grader/tasks/shadows/mixed/MixedDecks.h>
#include <grader/tasks/shadows/mixed/MixedScenes.h>
#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/support/Surfaces.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <utility>

namespace ticker::tasks {
namespace {

using raytracer::PointLight;
using raytracer::SceneDescription;
using raytracer::SphereDescription;

constexpr int kScenesOfEach = 16;
constexpr int kPoints = 4;
constexpr int kTries = 60;
constexpr std::uint32_t kLeastCapacity = 64;

const Vector3 kEye;
constexpr double kOffObjects = 1.4;  // of lights from other objects, in radii of the light
constexpr double kOffPoints = 0.1;   // of points from other objects, world units

/// The surface that the points lie on: a plane, or a ball.
struct Ground {
    Vector3 foot;
    Vector3 up;
    double radius = 0.0;  ///< 0: a plane
    double reach = 0.15;  ///< of the points from the foot
};

class Mixer {
public:
    Mixer(Draw& draw, MixedDecks& decks, const raytracer::RenderSettings& settings)
        : draw_(draw), decks_(decks) {
        drawn_.question.settings = settings;
    }

    ShadowQuestion scene(ShadowQuestion::Purpose purpose) {
        drawn_.purpose = purpose;
        scene().ambientLighting = ColourRGB{decks_.ambient.deal().number(draw_)};
        drawGround();
        const int lights = decks_.lights.deal();
        for (int i = 0; i < lights; ++i)
            addLight();
        for (std::size_t i = 0; i < scene().pointLights.size(); ++i)
            addCompany(scene().pointLights[i].position());
        const int object = addGround();
        for (int i = 0; i < kTries && drawn_.question.points.size() < kPoints; ++i)
            addPoint(object);
        setCapacity(drawn_);
        drawn_.question.eventCapacity = std::max(drawn_.question.eventCapacity, kLeastCapacity);
        return std::move(drawn_);
    }

private:
    SceneDescription& scene() { return drawn_.question.scene; }
    [[nodiscard]] double lightSize() const { return drawn_.question.settings.lightSize; }

    void drawGround() {
        constexpr double kAside = 12.0;
        ground_.foot = drawPlace(draw_);
        const PlaceKind place = decks_.place.deal();
        if (place == PlaceKind::behindCamera) ground_.foot.z *= -1.0;
        if (place == PlaceKind::aside) ground_.foot = ground_.foot + draw_.direction() * kAside;
        ground_.up = draw_.direction();
        ground_.radius = decks_.ball.deal().number(draw_);
        if (ground_.radius > 0.0) ground_.reach = std::min(ground_.reach, 0.3 * ground_.radius);
    }

    void addLight() {
        const bool isInFront = decks_.side.deal() == LightSide::inFront;
        const double distance = decks_.distance.deal().number(draw_);
        const double level = decks_.level.deal().number(draw_);
        const ColourRGB colour = tinted(draw_, decks_.tint.deal(), 0.4, 1.0);
        const double intensity = level * 4.0 * std::numbers::pi * distance * distance;
        for (int i = 0; i < kTries; ++i) {
            const Vector3 towards =
                draw_.directionAround(isInFront ? ground_.up : -ground_.up, 1.3);
            const PointLight light{ground_.foot + towards * distance, colour, intensity};
            const auto& others = scene().pointLights;
            const bool isClear =
                isOffHorizon(light, ground_.foot, ground_.up, lightSize()) &&
                showsNoHighlightFromBehind(light, ground_.foot, ground_.up, kEye, lightSize()) &&
                isOffGround(light) && std::ranges::all_of(others, [&](const PointLight& other) {
                    return areApart(light, other, ground_.foot, lightSize());
                });
            if (!isClear) continue;
            scene().pointLights.push_back(light);
            return;
        }
    }

    [[nodiscard]] bool isOffGround(const PointLight& light) const {
        if (ground_.radius == 0.0) return true;
        const double height = (light.position() - centre()).magnitude() - ground_.radius;
        return std::abs(height) > kOffObjects * lightSize();
    }

    /// What stands before a light or behind it.
    void addCompany(const Vector3& light) {
        // Seen from very far, an object's edge moves in single precision.
        constexpr double kVeryFar = 100.0;
        if ((light - ground_.foot).magnitude() > kVeryFar) return;
        const Company company = decks_.company.deal();
        if (company == Company::before || company == Company::both) addObject(light, true);
        if (company == Company::behind || company == Company::both) addObject(light, false);
    }

    void addObject(const Vector3& light, bool isBefore) {
        const bool isPlane = decks_.shape.deal() == Shape::plane;
        const raytracer::Material material = decks_.others.deal();
        const Vector3 way = light - ground_.foot;
        const double distance = way.magnitude();
        const Vector3 towards = way / distance;
        for (int i = 0; i < kTries; ++i) {
            const double share = draw_.between(0.25, 0.65);
            // Radius of a ball: 0.6 to 2 times that of the bundle of rays from the points to the
            // light.
            const double wide = (share * 1.4 * lightSize() + (1.0 - share) * ground_.reach) *
                                draw_.between(0.6, 2.0);
            const Vector3 middle = isBefore ? ground_.foot + way * share
                                            : light + towards * (wide + kOffObjects * lightSize() +
                                                                 draw_.between(0.05, 1.0));
            if (isPlane ? tryPlane(middle, draw_.directionAround(towards, 0.5), material)
                        : tryBall(middle, wide, material))
                return;
        }
    }

    bool tryBall(const Vector3& centre, double radius, const raytracer::Material& material) {
        const bool isClear = keepsOff([&](const Vector3& place, double distance) {
            return (place - centre).magnitude() > radius + distance;
        });
        if (isClear) scene().spheres.push_back({centre, radius, material, nullptr});
        return isClear;
    }

    bool tryPlane(const Vector3& point, const Vector3& normal,
                  const raytracer::Material& material) {
        const bool isClear = keepsOff([&](const Vector3& place, double distance) {
            return std::abs((place - point).dot(normal)) > distance;
        });
        const bool isTurned = draw_.whole(0, 1) == 0;
        if (isClear) scene().planes.push_back({point, isTurned ? -normal : normal, material});
        return isClear;
    }

    /// @param isOff  Whether an object is farther from a place than a distance.
    /// @return       Whether that holds for the points and for each light.
    template <typename IsOff>
    bool keepsOff(const IsOff& isOff) {
        return isOff(ground_.foot, ground_.reach + kOffPoints) &&
               std::ranges::all_of(scene().pointLights, [&](const PointLight& light) {
                   return isOff(light.position(), kOffObjects * lightSize());
               });
    }

    /// @return  Its index among the objects.
    int addGround() {
        const raytracer::Material material = decks_.surface.deal();
        if (ground_.radius == 0.0) {
            auto& planes = scene().planes;
            const int at = draw_.whole(0, static_cast<int>(planes.size()));
            planes.insert(planes.begin() + at, {ground_.foot, ground_.up, material});
            return static_cast<int>(scene().spheres.size()) + at;
        }
        auto& spheres = scene().spheres;
        const int at = draw_.whole(0, static_cast<int>(spheres.size()));
        spheres.insert(spheres.begin() + at, {centre(), ground_.radius, material, nullptr});
        return at;
    }

    [[nodiscard]] Vector3 centre() const { return ground_.foot - ground_.up * ground_.radius; }

    void addPoint(int object) {
        Vector3 normal = ground_.up;
        Vector3 point = ground_.foot;
        if (ground_.radius > 0.0) {
            normal = draw_.directionAround(ground_.up, ground_.reach / ground_.radius);
            point = centre() + normal * ground_.radius;
        } else {
            const Perpendiculars sides = perpendicularsOf(normal);
            point += sideAt(sides, draw_.between(0.0, 2.0 * std::numbers::pi)) *
                     draw_.between(0.0, ground_.reach);
        }
        const Vector3 viewer = viewerOf(point, normal);
        if (!isClear(point, normal, viewer)) return;
        drawn_.question.points.push_back({object, point, normal, viewer});
        drawn_.zones.push_back(zonesOf(scene(), Surfaces{scene()}, point, normal, lightSize()));
    }

    Vector3 viewerOf(const Vector3& point, const Vector3& normal) {
        constexpr double kAbove = 0.05;
        const ViewerKind kind = decks_.viewer.deal();
        const Vector3 onLens = drawLensPoint(draw_, drawn_.question.settings);
        const auto& lights = scene().pointLights;
        const auto lit = std::ranges::find_if(lights, [&](const PointLight& light) {
            return (light.position() - point).dot(normal) > 0.0;
        });
        if (kind == ViewerKind::mirrored && lit != lights.end())
            return drawViewer(draw_, point, normal, lit->position());
        if (kind == ViewerKind::onLens && (onLens - point).normalised().dot(normal) > kAbove)
            return onLens;
        return point + draw_.directionAround(normal, 1.3) * draw_.between(1.0, 15.0);
    }

    [[nodiscard]] bool isClear(const Vector3& point, const Vector3& normal,
                               const Vector3& viewer) const {
        const auto& lights = drawn_.question.scene.pointLights;
        for (std::size_t i = 0; i < lights.size(); ++i) {
            if (!isOffHorizon(lights[i], point, normal, lightSize()) ||
                !isFarOff(lights[i], point, lightSize()) ||
                !showsNoHighlightFromBehind(lights[i], point, normal, kEye, lightSize()) ||
                !showsNoHighlightFromBehind(lights[i], point, normal, viewer, lightSize()))
                return false;
            for (std::size_t k = 0; k < i; ++k)
                if (!areApart(lights[i], lights[k], point, lightSize())) return false;
        }
        return true;
    }

    Draw& draw_;
    MixedDecks& decks_;
    ShadowQuestion drawn_;
    Ground ground_;
};

void addScenes(Draw& draw, ShadowQuestion::Purpose purpose, std::vector<Between> distances,
               std::vector<ShadowQuestion>& drawn) {
    MixedDecks decks{.draw = draw, .distance = {draw, std::move(distances)}};
    Deck<int> counts{draw, {1, 3, 12}};
    for (int i = 0; i < kScenesOfEach; ++i) {
        raytracer::RenderSettings settings;
        if (purpose == ShadowQuestion::Purpose::mixedNear) {
            settings.lightSize = draw.between(0.05, 0.09);
            settings.shadowRayCount = counts.deal();
        }
        ShadowQuestion scene = Mixer{draw, decks, settings}.scene(purpose);
        if (!scene.question.points.empty()) drawn.push_back(std::move(scene));
    }
}

}  // namespace

std::vector<ShadowQuestion> drawMixedScenes(Draw& draw) {
    std::vector<ShadowQuestion> drawn;
    addScenes(draw, ShadowQuestion::Purpose::mixed,
              {{1.5, 2.5}, {3.0, 8.0}, {20.0, 45.0}, {1200.0, 9000.0}}, drawn);
    addScenes(draw, ShadowQuestion::Purpose::mixedNear, {{0.65, 0.95}, {0.95, 3.0}}, drawn);
    return drawn;
}

}  // namespace ticker::tasks
