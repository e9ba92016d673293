// Where the camera rays start.
#include <lens/DepthOfField.h>
#include <lens/LensPoints.h>
#include <raytracer/math/Vector3.h>
#include <support/Complaint.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace raytracer::tests::lens {
namespace {

TEST_F(DepthOfField, EachPixelGetsEnoughRays) {
    if (!trial().sawRays()) GTEST_SKIP() << kUnseen;
    const auto wanted = static_cast<std::size_t>(handout_.dofRayCount);
    if (trial().fewestRays() >= wanted) return;
    complain(kAsked, "at least " + std::to_string(wanted) + " camera rays for each pixel",
             std::to_string(trial().fewestRays()), "the loop runs settings().dofRayCount times",
             "Depth of field (T2.2), step 2");
}

TEST_F(DepthOfField, RaysStartAllOverTheLens) {
    if (!trial().sawRays()) GTEST_SKIP() << kUnseen;
    const LensPoints lens{trial()};
    const auto wanted = static_cast<std::size_t>(handout_.dofRayCount);
    if (lens.distinct * 2 >= wanted) return;
    complain(kAsked + ": where the rays start", "many different points of the lens",
             std::to_string(lens.distinct) + " in all",
             lens.distinct == 1 ? "every ray starts at the eye: give each one an origin of its own"
                                : "draw a new lens point for each ray, not for each frame",
             "Depth of field (T2.2), step 2");
}

TEST_F(DepthOfField, EachRayOfAPixelHasItsOwnLensPoint) {
    if (!trial().sawRays()) GTEST_SKIP() << kUnseen;
    const Trial once{twoBalls(), 1};
    const LensPoints lens{once};
    const auto wanted = static_cast<std::size_t>(handout_.dofRayCount);
    if (lens.distinct * 2 >= wanted) return;
    complain("one frame of 2 x 1 pixels: where the rays start",
             "many different points of the lens for each pixel",
             std::to_string(lens.distinct) + " in all",
             "the lens point must be drawn inside the innermost loop",
             "Depth of field (T2.2), step 2");
}

TEST_F(DepthOfField, TheLensIsASquareAroundTheEye) {
    if (!trial().sawRays()) GTEST_SKIP() << kUnseen;
    const LensPoints lens{trial()};
    const double amount = handout_.dofAmount;
    // The bounds are wider for few points: the cell centres of a regular grid reach less far than
    // random points, and fifty random points that all pixels share are less even. The chance that
    // one end lies farther from the eye than the other by 0.7 half-widths is below 1e-7.
    const bool few = lens.distinct <= 500;
    const double least = few ? 0.75 : 0.96;
    const std::string expected = "a square in the plane z = 0, centred on the eye";
    const std::string section = "Depth of field (T2.2), step 2";
    const double off =
        std::max(std::abs(lens.low.x + lens.high.x), std::abs(lens.low.y + lens.high.y));
    const auto fits = [&](double half) {
        return lens.widest() <= 1.003 * half && lens.widest() >= least * half;
    };
    if (lens.high.z - lens.low.z > 1e-4 || std::abs(lens.high.z) > 1e-4)
        complain(kAsked + ": where the rays start", expected,
                 "z from " + inWords(lens.low.z) + " to " + inWords(lens.high.z),
                 "the lens is flat: only x and y are random", section);
    else if (off > (few ? 0.7 : 0.1) * lens.widest() + 1e-9)
        complain(kAsked + ": where the rays start", expected,
                 "x from " + inWords(lens.low.x) + " to " + inWords(lens.high.x) + ", y from " +
                     inWords(lens.low.y) + " to " + inWords(lens.high.y),
                 "random numbers from 0 to 1 where -1 to 1 was meant", section);
    else if (!fits(amount) && !fits(0.5 * amount))
        complain(kAsked + ": where the rays start",
                 "half a side of settings().dofAmount, or half of that (both readings are right)",
                 "half a side of " + inWords(lens.widest()), "scale by settings().dofAmount once",
                 section);
    else if (lens.narrowest() < (few ? 0.6 : 0.75) * lens.widest())
        complain(kAsked + ": where the rays start", expected,
                 "x from " + inWords(lens.low.x) + " to " + inWords(lens.high.x) + ", y from " +
                     inWords(lens.low.y) + " to " + inWords(lens.high.y),
                 "both coordinates are random", section);
}

TEST_F(DepthOfField, LensPointsFillTheSquareEvenly) {
    if (!trial().sawRays()) GTEST_SKIP() << kUnseen;
    const LensPoints lens{trial()};
    if (!(lens.narrowest() > 1e-6)) return;  // another test reports it
    const Vector3 middle = (lens.low + lens.high) / 2.0;
    double corners = 0.0;
    double inner = 0.0;
    double diagonal = 0.0;
    for (const Vector3& point : lens.points) {
        const double x = (point.x - middle.x) / lens.widest();
        const double y = (point.y - middle.y) / lens.widest();
        if (x * x + y * y > 1.0) corners += 1.0;
        if (std::max(std::abs(x), std::abs(y)) < 0.5) inner += 1.0;
        diagonal += 3.0 * x * y;
    }
    const double count = static_cast<double>(lens.points.size());
    // A square has 21 % of its points outside of the largest disc in it, 25 % in its inner quarter,
    // and x and y are independent. For 50 points, the standard deviation of the shares is 0.06, and
    // that of the diagonal 0.14.
    const bool few = lens.distinct <= 500;
    const double slack = few ? 0.2 : 0.06;
    std::string got;
    std::string cause = "x and y are uniform, each by itself, from -1 to 1";
    if (corners / count < 0.215 - slack) {
        got = percent(corners / count) + " of the points lie in the corners";
        cause = "the lens is a disc; a square was asked for";
    } else if (std::abs(inner / count - 0.25) > 1.5 * slack) {
        got = percent(inner / count) + " of the points lie in the inner quarter of the square";
    } else if (std::abs(diagonal / count) > (few ? 0.8 : 0.12)) {
        got = "points along a diagonal";
        cause = "x and y need random numbers of their own";
    }
    if (!got.empty())
        complain(kAsked + ": where the rays start", "points evenly all over a square", got, cause,
                 "Depth of field (T2.2), step 2");
}

}  // namespace
}  // namespace raytracer::tests::lens
