#ifndef TICKER_TASKS_MAINTICK_PHONGMODEL_H
#define TICKER_TASKS_MAINTICK_PHONGMODEL_H

#include <grader/tasks/maintick/Exact.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace ticker::tasks::maintick {

/// Arguments of one call of `Renderer::illuminate` in a scene without shadows.
struct LitSetup {
    raytracer::SceneDescription scene;  ///< its first sphere is the object
    Vector3 P;
    Vector3 N;
    Vector3 O;
};

/// What illuminate works out, in the order of `PhongStep`.
struct PhongTerms {
    const LitSetup& setup;
    raytracer::Material material;
    ColourRGB ambient{};
    ColourRGB diffuse{};   ///< of all lights so far
    ColourRGB specular{};  ///< of all lights so far
    std::size_t light = 0;
    Vector3 L{};
    Vector3 V{};
    double distance = 0.0;   ///< of the light
    double facing = 0.0;     ///< N.L
    double mirrored = 0.0;   ///< R.V
    ColourRGB arriving{};    ///< I
    double share = 0.0;      ///< ks (R.V)^alpha
    ColourRGB ownDiffuse{};  ///< of this light
    ColourRGB ownSpecular{};
    ColourRGB colour{};  ///< the answer

    [[nodiscard]] const raytracer::PointLight& lamp() const {
        return setup.scene.pointLights[light];
    }
    [[nodiscard]] Vector3 path() const { return lamp().position() - setup.P; }
};

/// The step after which a mistake changes the terms. `material` and `colour` happen once, the other
/// steps once for each light.
enum class PhongStep : std::uint8_t { material, ways, cosines, clamped, light, colour };

/// A known mistake: its name, what code with it works out instead, and what mends it.
struct PhongMistake {
    const FindingText* finding;
    PhongStep step;
    void (*change)(PhongTerms&);
    const char* hint = "";  ///< empty: that of `finding`
};

inline constexpr const char* kFaintLight =
    "Faint lights count as well: many of them add up. Leave no light out for what it adds, however "
    "little that is.";

/// The known mistakes of M2. The first one that explains all answers is named.
[[nodiscard]] std::span<const PhongMistake> phongMistakes();

/// The right colour, or the one that code with this mistake gives.
[[nodiscard]] ColourRGB phong(const LitSetup& setup, const PhongMistake* mistake = nullptr);

}  // namespace ticker::tasks::maintick

#endif
