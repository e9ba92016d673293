#include <grader/tests/tasks/maintick/LitMistakes.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace ticker::tasks::maintick {
namespace {

// By hand, in the red channel: kd = 0.5, ks = 0.75, alpha = 2, N.L = 0.6, R.V = 0.8, and the light,
// of colour 0.5, arrives as I = 2 from a distance of 2.
constexpr double kAmbientPart = 0.4 * 0.25;
constexpr double kDiffusePart = 0.4 * 2.0 * 0.5 * 0.6;
constexpr double kSpecularPart = 0.5 * 2.0 * 0.75 * 0.64;
// Of a second light straight above the point, I = 0.5, R.V = N.V = 0.96.
constexpr double kDiffuseAbove = 0.4 * 0.5 * 0.5;
constexpr double kSpecularAbove = 0.5 * 0.5 * 0.75 * 0.9216;

const Vector3 kP{0.0, 0.0, 4.0};
const Vector3 kUp{0.0, 0.0, -1.0};
const Vector3 kTowardsLight{0.8, 0.0, -0.6};
const Vector3 kTowardsViewer{-0.28, 0.0, -0.96};

LitSetup litByHand(const Vector3& N = kUp, const Vector3& V = kTowardsViewer) {
    LitSetup setup{{}, kP, N, kP + V * 5.0};
    setup.scene.ambientLighting = ColourRGB{0.25};
    raytracer::Material material;
    material.colour = ColourRGB{0.4};
    material.phongKD = 0.5;
    material.phongKS = 0.75;
    material.phongAlpha = 2.0;
    setup.scene.spheres.push_back({{}, 0.02, material, nullptr});
    setup.scene.pointLights.emplace_back(kP + kTowardsLight * 2.0, ColourRGB{0.5},
                                         64.0 * std::numbers::pi);
    return setup;
}

LitSetup withLightAbove(double distance) {
    LitSetup setup = litByHand();
    setup.scene.pointLights.emplace_back(kP + kUp * distance, ColourRGB{0.5},
                                         4.0 * std::numbers::pi * distance * distance);
    return setup;
}

struct Worked {
    LitMistake mistake;
    double ambient;
    double diffuse;
    double specular;
};

void expectWorked(const LitSetup& setup, const std::vector<Worked>& rows) {
    for (const Worked& row : rows)
        EXPECT_NEAR(phongOf(row.mistake, setup).r, row.ambient + row.diffuse + row.specular, 1e-12)
            << "mistake " << static_cast<int>(row.mistake);
}

TEST(PhongModel, GivesEveryMistakeItsValueOfOneLight) {
    using enum LitMistake;
    ASSERT_EQ(phongMistakes().size(), static_cast<std::size_t>(specularShareAtMostOne));
    constexpr double A = kAmbientPart;
    constexpr double D = kDiffusePart;
    constexpr double S = kSpecularPart;
    const raytracer::Material usual;
    expectWorked(litByHand(), {{none, A, D, S},
                               {ambientMissing, 0.0, D, S},
                               {ambientTimesKd, A * 0.5, D, S},
                               {ambientColourless, 0.25, D, S},
                               {ambientPerLight, A, D, S},
                               {ambientAgainPerLight, 2.0 * A, D, S},
                               {ambientInShadeAlone, 0.0, D, S},
                               {diffuseMissing, A, 0.0, S},
                               {diffuseColourless, A, D / 0.4, S},
                               {diffuseWithoutI, A, D / 2.0, S},
                               {diffuseWithoutKd, A, D / 0.5, S},
                               {diffuseLightTwice, A, D * 0.5, S},
                               {specularMissing, A, D, 0.0},
                               {specularObjectColour, A, D, S / 0.5 * 0.4},
                               {specularLightOnce, A, D, S / 0.5},
                               {specularWithoutI, A, D, S / 2.0},
                               {specularWithoutKs, A, D, S / 0.75},
                               {specularAlphaMissing, A, D, S / 0.8},
                               {specularPowerOfAll, A, D, S * 0.75},
                               {specularAtMostOne, A, D, S},
                               {coefficientsExchanged, A, D / 0.5 * 0.75, S / 0.75 * 0.5},
                               {lightsMissing, A, 0.0, 0.0},
                               {flat, 0.4, 0.0, 0.0},
                               {defaultCoefficients, A, D / 0.5 * usual.phongKD,
                                usual.phongKS * std::pow(0.8, usual.phongAlpha)},
                               {farLightsMissing, A, D, S},
                               {lastHighlightOnly, A, D, S},
                               {firstLightOnly, A, D, S},
                               {faintLightsMissing, A, D, S},
                               {lastLightOnly, A, D, S},
                               {averaged, A, D, S},
                               {nearLimited, A, D, S},
                               {clamped, A, D, S},
                               {rimLeftOut, A, D, S},
                               {diffuseShareAtMostOne, A, D, S},
                               {specularShareAtMostOne, A, D, S}});
}

TEST(PhongModel, GivesEveryWrongDirectionItsCosines) {
    using enum LitMistake;
    constexpr double A = kAmbientPart;
    constexpr double D = kDiffusePart;
    constexpr double S = kSpecularPart;
    const auto highlightOf = [](double squaredCosine) { return 0.75 * squaredCosine; };
    expectWorked(litByHand(), {{halfVector, A, D, highlightOf(1.56 * 1.56 / 2.704)},
                               {viewFromCamera, A, D, highlightOf(0.36)},
                               {viewReversed, A, D, 0.0},
                               {viewNotUnit, A, D, highlightOf(16.0)},
                               {viewIsO, A, D, highlightOf(2.56 / 2.6)},
                               {mirrorOfView, A, D, 0.0},
                               {cosineOfNandV, A, D, highlightOf(0.9216)},
                               {cosineOfLandV, A, D, highlightOf(0.352 * 0.352)},
                               {lightNotUnit, A, D * 2.0, S * 4.0},
                               {lightReversed, A, 0.0, 0.0},
                               {lightFromWorldOrigin, A, 0.0, 0.0},
                               {facingUnclamped, A, D, S},
                               {facingAbsolute, A, D, S},
                               {mirroredUnclamped, A, D, S},
                               {mirroredAbsolute, A, D, S},
                               {bothUnclamped, A, D, S},
                               {normalTurned, A, D, S}});
}

TEST(PhongModel, GivesWhatLiesBehindItsSign) {
    using enum LitMistake;
    constexpr double A = kAmbientPart;
    constexpr double D = kDiffusePart;
    constexpr double S = kSpecularPart;
    // The light and the viewer behind the surface: N.L = -0.6, R.V = 0.8.
    expectWorked(litByHand(-kUp), {{none, A, 0.0, S},
                                   {facingUnclamped, A, -D, S},
                                   {bothUnclamped, A, -D, S},
                                   {facingAbsolute, A, D, S},
                                   {normalTurned, A, D, S},
                                   {mirroredAbsolute, A, 0.0, S}});
    // The viewer alone: N.L = 0.6, R.V = -0.8, whose square is positive.
    expectWorked(litByHand(kUp, -kTowardsViewer), {{none, A, D, 0.0},
                                                   {mirroredUnclamped, A, D, S},
                                                   {mirroredAbsolute, A, D, S},
                                                   {bothUnclamped, A, D, S},
                                                   {mirrorOfView, A, D, S},
                                                   {viewReversed, A, D, S},
                                                   {facingAbsolute, A, D, 0.0},
                                                   {normalTurned, A, 0.0, 0.0}});
}

TEST(PhongModel, GivesARimThatIsLeftOutNoHighlight) {
    // R = (-0.8, 0, -0.6), R.V = 0.2.
    const double along = std::sqrt(1.0 - 0.04);
    const Vector3 V = Vector3{-0.8, 0.0, -0.6} * 0.2 + Vector3{0.6, 0.0, -0.8} * along;
    expectWorked(litByHand(kUp, V),
                 {{LitMistake::none, kAmbientPart, kDiffusePart, 0.5 * 2.0 * 0.75 * 0.04},
                  {LitMistake::rimLeftOut, kAmbientPart, kDiffusePart, 0.0}});
}

TEST(PhongModel, GivesAHighlightAtMostTheLightItself) {
    LitSetup setup = litByHand();
    setup.scene.spheres[0].material.phongKS = 3.0;
    expectWorked(setup, {{LitMistake::none, kAmbientPart, kDiffusePart, kSpecularPart * 4.0},
                         {LitMistake::specularAtMostOne, kAmbientPart, kDiffusePart, 0.5 * 2.0}});
}

TEST(PhongModel, CutsCoefficientsAboveOneAlone) {
    LitSetup setup = litByHand();
    setup.scene.spheres[0].material.phongKD = 1.5;
    setup.scene.spheres[0].material.phongKS = 1.5;
    const double diffuse = 3.0 * kDiffusePart;
    const double specular = 2.0 * kSpecularPart;
    expectWorked(
        setup, {{LitMistake::none, kAmbientPart, diffuse, specular},
                {LitMistake::diffuseShareAtMostOne, kAmbientPart, 2.0 * kDiffusePart, specular},
                {LitMistake::specularShareAtMostOne, kAmbientPart, diffuse, kSpecularPart / 0.75}});
}

// The mistake leaves out light that adds less than 1/255: all of 0.0038, nothing of 0.0041.
TEST(PhongModel, LeavesOutFaintLightsAlone) {
    for (const double added : {0.0038, 0.0041}) {
        LitSetup setup = litByHand();
        const double share = added / (kDiffusePart + kSpecularPart);
        raytracer::PointLight& light = setup.scene.pointLights[0];
        light = {light.position(), light.colour(), light.intensity() * share};
        expectWorked(setup, {{LitMistake::none, kAmbientPart, added, 0.0},
                             {LitMistake::faintLightsMissing, kAmbientPart,
                              added < 0.004 ? 0.0 : added, 0.0}});
    }
}

TEST(PhongModel, GivesEveryWrongFalloffItsShare) {
    using enum LitMistake;
    const double both = kDiffusePart + kSpecularPart;
    // I = 2 is 16 / 4 / 2: the intensity 64 pi over 4 pi, over the square of the distance 2, times
    // the colour 0.5.
    expectWorked(litByHand(), {{falloffMissing, kAmbientPart, both * 4.0, 0.0},
                               {intensityAlone, kAmbientPart, both * 16.0 * std::numbers::pi, 0.0},
                               {falloffLinear, kAmbientPart, both * 2.0, 0.0},
                               {falloffSquaredAgain, kAmbientPart, both / 4.0, 0.0},
                               {falloffFromViewer, kAmbientPart, both * 4.0 / 21.96, 0.0},
                               {falloffFromOrigin, kAmbientPart, both * 4.0 / 10.4, 0.0},
                               {fourPiMissing, kAmbientPart, both * 4.0 * std::numbers::pi, 0.0}});
}

// At half a unit I is 32; from a distance of 1 it would be 8.
TEST(PhongModel, LimitsHowNearALightIs) {
    LitSetup setup = litByHand();
    raytracer::PointLight& light = setup.scene.pointLights[0];
    light = {kP + kTowardsLight * 0.5, light.colour(), light.intensity()};
    const double both = kDiffusePart + kSpecularPart;
    expectWorked(setup, {{LitMistake::none, kAmbientPart, both * 16.0, 0.0},
                         {LitMistake::nearLimited, kAmbientPart, both * 4.0, 0.0}});
}

TEST(PhongModel, GivesEveryMistakeItsSumOfTwoLights) {
    using enum LitMistake;
    constexpr double A = kAmbientPart;
    constexpr double D = kDiffusePart + kDiffuseAbove;
    constexpr double S = kSpecularPart + kSpecularAbove;
    for (const double distance : {9.9, 10.1}) {
        SCOPED_TRACE(distance);
        const bool isFar = distance > 10.0;
        expectWorked(withLightAbove(distance),
                     {{none, A, D, S},
                      {ambientPerLight, 2.0 * A, D, S},
                      {ambientAgainPerLight, 3.0 * A, D, S},
                      {firstLightOnly, A, kDiffusePart, kSpecularPart},
                      {lastLightOnly, A, kDiffuseAbove, kSpecularAbove},
                      {lastHighlightOnly, A, D, kSpecularAbove},
                      {averaged, A, D / 2.0, S / 2.0},
                      {farLightsMissing, A, isFar ? kDiffusePart : D, isFar ? kSpecularPart : S},
                      {clamped, 1.0, 0.0, 0.0}});
    }
}

TEST(PhongModel, LosesTheLightsAfterOneThatEndsTheLoop) {
    using enum LitMistake;
    const auto withSecondAlong = [](LitSetup setup, const Vector3& way) {
        setup.scene.pointLights.emplace_back(kP + way, ColourRGB{0.5}, 4.0 * std::numbers::pi);
        return setup;
    };
    // The first light is behind: N.L = -0.6, R.V = -0.8. The second is in front, as the viewer is.
    expectWorked(withSecondAlong(litByHand(-kUp, -kTowardsViewer), -kUp),
                 {{none, kAmbientPart, kDiffuseAbove, kSpecularAbove},
                  {endsAtLightBehind, kAmbientPart, 0.0, 0.0},
                  {endsWithoutHighlight, kAmbientPart, 0.0, 0.0}});
    // Both lights in front, without a highlight: N.L = 0.6 and 1, R.V = -0.8 and -0.96.
    expectWorked(withSecondAlong(litByHand(kUp, -kTowardsViewer), kUp),
                 {{none, kAmbientPart, kDiffusePart + kDiffuseAbove, 0.0},
                  {endsAtLightBehind, kAmbientPart, kDiffusePart + kDiffuseAbove, 0.0},
                  {endsWithoutHighlight, kAmbientPart, kDiffusePart, 0.0}});
}

TEST(PhongModel, GivesAmbientLightWhereThereIsNoOther) {
    LitSetup setup = litByHand();
    setup.scene.pointLights.clear();
    EXPECT_NEAR(phongOf(LitMistake::averaged, setup).r, kAmbientPart, 1e-12);
    EXPECT_NEAR(phongOf(LitMistake::ambientInShadeAlone, setup).r, kAmbientPart, 1e-12);
}

}  // namespace
}  // namespace ticker::tasks::maintick
