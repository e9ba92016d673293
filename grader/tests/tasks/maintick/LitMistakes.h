#ifndef TICKER_TESTS_MAINTICK_LITMISTAKES_H
#define TICKER_TESTS_MAINTICK_LITMISTAKES_H

#include <grader/tasks/maintick/PhongModel.h>

#include <cstddef>

namespace ticker::tasks::maintick {

/// `none` is the right way; the others are the rows of phongMistakes(), in their order.
enum class LitMistake : std::size_t {
    none,
    flat,
    lightsMissing,
    ambientMissing,
    ambientPerLight,
    ambientAgainPerLight,
    ambientInShadeAlone,
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
    specularAtMostOne,
    coefficientsExchanged,
    halfVector,
    viewFromCamera,
    viewReversed,
    mirrorOfView,
    viewNotUnit,
    viewIsO,
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
    normalTurned,
    defaultCoefficients,
    farLightsMissing,
    lastHighlightOnly,
    falloffMissing,
    intensityAlone,
    falloffLinear,
    falloffSquaredAgain,
    falloffFromViewer,
    falloffFromOrigin,
    fourPiMissing,
    firstLightOnly,
    endsAtLightBehind,
    endsWithoutHighlight,
    faintLightsMissing,
    lastLightOnly,
    averaged,
    nearLimited,
    clamped,
    rimLeftOut,
    diffuseShareAtMostOne,
    specularShareAtMostOne
};

inline ColourRGB phongOf(LitMistake mistake, const LitSetup& setup) {
    const auto row = static_cast<std::size_t>(mistake);
    return phong(setup, row == 0 ? nullptr : &phongMistakes()[row - 1]);
}

}  // namespace ticker::tasks::maintick

#endif
