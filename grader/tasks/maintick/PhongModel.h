#ifndef TICKER_TASKS_MAINTICK_PHONGMODEL_H
#define TICKER_TASKS_MAINTICK_PHONGMODEL_H

#include <grader/tasks/maintick/Exact.h>

#include <cstdint>

namespace ticker::tasks::maintick {

/// What one call of illuminate gets, where nothing casts a shadow.
struct LitSetup {
    raytracer::SceneDescription scene;  ///< its first sphere is the object
    Vector3 P;
    Vector3 N;
    Vector3 O;
};

/// Known mistakes in Phong's model; `none` is the right one.
enum class PhongMistake : std::uint8_t {
    none,
    ambientMissing,
    ambientPerLight,
    ambientTimesKd,
    ambientColourless,
    diffuseMissing,
    diffuseColourless,
    diffuseWithoutI,
    diffuseWithoutKd,
    diffuseLightTwice,
    specularMissing,
    specularObjectColour,
    specularLightOnce,
    specularWithoutI,
    specularWithoutKs,
    specularAlphaMissing,
    specularPowerOfAll,
    coefficientsExchanged,
    halfVector,
    viewFromCamera,
    viewReversed,
    viewNotUnit,
    viewIsO,
    mirrorOfView,
    cosineOfNandV,
    cosineOfLandV,
    lightNotUnit,
    lightReversed,
    lightFromWorldOrigin,
    facingUnclamped,
    facingAbsolute,
    mirroredUnclamped,
    mirroredAbsolute,
    bothUnclamped,
    normalTurned,         ///< to the viewer
    defaultCoefficients,  ///< those of a scene element without any
    farLightsMissing,
    lastHighlightOnly,
    falloffMissing,
    falloffLinear,
    falloffSquaredAgain,
    falloffFromViewer,
    falloffFromOrigin,
    fourPiMissing,
    firstLightOnly,
    lastLightOnly,
    averaged,
    clamped,
    lightsMissing,
    flat,
    kCount
};

/// The colour that code with this mistake gives.
[[nodiscard]] ColourRGB phongWith(PhongMistake mistake, const LitSetup& setup);

}  // namespace ticker::tasks::maintick

#endif
