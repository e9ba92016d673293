// The colour of a pixel from the colours of its rays.
#include <lens/DepthOfField.h>
#include <lens/LensPoints.h>
#include <raytracer/image/ColourRGB.h>
#include <raytracer/image/Image.h>
#include <raytracer/render/Renderer.h>
#include <support/Complaint.h>
#include <support/KeptScene.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace raytracer::tests::lens {
namespace {

TEST_F(DepthOfField, AWallOfOneColourKeepsItsColour) {
    const Trial trial{wall(), 3};
    const ColourRGB expected{0.3, 0.5, 0.7};
    for (const std::size_t pixel : {0U, 1U})
        for (const ColourRGB& got : trial.colours(pixel)) {
            if (std::abs(got.g - expected.g) < 1e-3) continue;
            const double factor = got.g / expected.g;
            complain("a wall of one colour in ambient light", "that colour",
                     inWords(factor) + " times that colour",
                     "the pixel gets the mean: the sum of all contributions, divided by their "
                     "number, once",
                     "Depth of field (T2.2), step 3");
            return;
        }
}

// Every ray of every pixel sees one colour, so that the picture has that colour for all random
// numbers.
TEST_F(DepthOfField, AWallOfOneColourKeepsItsColourWithSeveralThreads) {
    RenderSettings settings;
    settings.width = 64;
    settings.height = 48;
    settings.threads = 4;
    const Scene& scene = keptScene(wall());
    const Image image = Renderer{settings}.render(scene);
    const ColourRGB& first = image.at(0, 0);
    const auto differ = std::count_if(
        image.pixels().begin(), image.pixels().end(),
        [&](const ColourRGB& colour) { return !(std::abs(colour.g - first.g) < 1e-3); });
    if (differ == 0) return;
    complain("a wall of one colour, 64 x 48 pixels, rendered by four threads", "one colour",
             std::to_string(differ) + " pixels of another colour than the first",
             "forEachPixel works on several rows at once, so what a pixel adds up (sum, counters) "
             "is declared inside of the function that it is given",
             "Depth of field (T2.2), step 3");
}

TEST_F(DepthOfField, APixelIsTheAverageOfWhatItsRaysSee) {
    if (!trial().sawRays()) GTEST_SKIP() << kUnseen;
    if (trial().rays(0).empty() || trial().rays(1).empty()) return;  // another test reports it
    for (const std::size_t pixel : {0U, 1U}) {
        ColourRGB mean;
        for (const ColourRGB& colour : trial().colours(pixel))
            mean += colour / kRenders;
        const ColourRGB expected = trial().meanOfRays(pixel);
        const double apart = std::max({std::abs(mean.r - expected.r), std::abs(mean.g - expected.g),
                                       std::abs(mean.b - expected.b)});
        if (apart < 0.02) continue;
        complain(kAsked + " in front of two balls and a wall",
                 "(" + inWords(expected.r) + ", " + inWords(expected.g) + ", " +
                     inWords(expected.b) + "), the mean of what the pixel's rays meet",
                 "(" + inWords(mean.r) + ", " + inWords(mean.g) + ", " + inWords(mean.b) + ")",
                 "sum the linear colours of all rays, divide by their number, and set that very "
                 "pixel",
                 "Depth of field (T2.2), step 3");
        return;
    }
}

TEST_F(DepthOfField, APixelMixesColoursInEveryFrame) {
    if (!trial().sawRays()) GTEST_SKIP() << kUnseen;
    const LensPoints lens{trial()};
    if (lens.widest() < 0.05) return;  // another test reports it
    int pure = 0;
    for (const std::size_t pixel : {0U, 1U})
        for (const ColourRGB& colour : trial().colours(pixel)) {
            if (colour.b > 0.75) return;                  // not a mean: another test reports it
            const double share = (0.7 - colour.b) / 0.6;  // of the pixel, covered by the ball
            if (share < 0.005 || share > 0.995) ++pure;
        }
    if (pure < kRenders) return;
    complain(kAsked + " at the rims of two balls", "mixtures of ball and wall",
             "one of the two in " + std::to_string(pure) + " of " + std::to_string(2 * kRenders) +
                 " pixels",
             "the pixel must get the mean of all rays, not the last one or the median",
             "Depth of field (T2.2), step 3");
}

TEST_F(DepthOfField, AsManyReflectionsAreFollowedAsAsked) {
    if (trial().mostBounces() < 0) GTEST_SKIP() << "your code does not trace camera rays";
    const int wanted = handout_.bounces;
    if (trial().mostBounces() == wanted) return;
    complain("the last argument of trace",
             "settings().bounces, " + std::to_string(wanted) + " here",
             std::to_string(trial().mostBounces()),
             "each camera ray may be reflected as often as "
             "before",
             "Depth of field (T2.2), step 3");
}

}  // namespace
}  // namespace raytracer::tests::lens
