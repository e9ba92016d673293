#include <grader/tests/tasks/lens/LensByHand.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace ticker::tasks {
namespace {

constexpr double kAmount = 0.2;  // dofAmount of the handout
constexpr int kSide = 20;
// The share of the width that 400 independent points leave unused, or more, with a chance of 1e-11:
// n r^(n-1) - (n-1) r^n = 1e-11 for n = 400, solved for 1 - r.
constexpr double kShortfall = 0.06936778;

/// A pixel with a ray from every point of a lattice of `side` x `side`, which `place` maps from
/// [-1, 1].
template <typename Place>
void fill(LensByHand& lens, const Place& place, int side = kSide) {
    LensPixel& pixel = lens.pixel();
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j)
            pixel.rays.push_back(rayThrough(
                place(2.0 * i / (side - 1) - 1.0, 2.0 * j / (side - 1) - 1.0), {0.0, 0.0, 3.5}));
}

template <typename Place>
ApertureVerdict judge(const Place& place, int side = kSide) {
    LensByHand lens;
    fill(lens, place, side);
    return checkAperture(lens.log);
}

ApertureVerdict judgeSquare(double half) {
    return judge([half](double x, double y) { return Vector3{x * half, y * half, 0.0}; });
}

TEST(Aperture, IsTheWholeAmountOrHalfOfIt) {
    const ApertureVerdict whole = judgeSquare(kAmount);
    EXPECT_EQ(idOf(whole.finding), "");
    EXPECT_EQ(whole.factor, 1.0);
    const ApertureVerdict half = judgeSquare(0.5 * kAmount);
    EXPECT_EQ(idOf(half.finding), "");
    EXPECT_EQ(half.factor, 0.5);
}

TEST(Aperture, MayBeNarrowerByWhatChanceCanDoAndNoWider) {
    for (const double factor : {1.0, 0.5}) {
        const double half = factor * kAmount;
        EXPECT_EQ(idOf(judgeSquare(half * (1.0 - 0.99 * kShortfall)).finding), "") << factor;
        EXPECT_EQ(idOf(judgeSquare(half * (1.0 - 1.01 * kShortfall)).finding), "dof.aperture-size");
        EXPECT_EQ(idOf(judgeSquare(half * (1.0 + 0.9e-5)).finding), "") << factor;
        EXPECT_EQ(idOf(judgeSquare(half * (1.0 + 1.1e-5)).finding), "dof.aperture-size");
    }
}

TEST(Aperture, NamesThePlaneThatAllRaysStartIn) {
    const auto at = [](double z) {
        return judge([z](double x, double y) { return Vector3{x * 0.1, y * 0.1, z}; });
    };
    EXPECT_EQ(idOf(at(1e-7).finding), "");
    const ApertureVerdict verdict = at(1.0);
    EXPECT_EQ(idOf(verdict.finding), "dof.wrong");
    EXPECT_NE(verdict.finding.value_or(Finding{}).message.find("z is 1"), std::string::npos);
    EXPECT_EQ(idOf(judge([](double x, double y) {
                       return Vector3{x * 0.2, y * 0.2, x * 0.1};
                   }).finding),
              "dof.disc");
}

TEST(Aperture, TellsWhatWasSeen) {
    const ApertureVerdict verdict = judgeSquare(0.15);
    ASSERT_EQ(idOf(verdict.finding), "dof.aperture-size");
    EXPECT_NEAR(numberIn(*verdict.finding, "halfWidth"), 0.15, 1e-12);
    EXPECT_EQ(numberIn(*verdict.finding, "points"), 400.0);
    int corners = 0;
    for (int i = 0; i < kSide; ++i)
        for (int j = 0; j < kSide; ++j)
            corners += std::hypot(2.0 * i / (kSide - 1) - 1.0, 2.0 * j / (kSide - 1) - 1.0) > 1.0;
    EXPECT_NEAR(numberIn(*verdict.finding, "shareInCorners"), corners / 400.0, 1e-12);
    // A lattice whose ends lie on the rim is off by one step of its distribution function.
    EXPECT_NEAR(numberIn(*verdict.finding, "largestGap"), 1.0 / kSide, 1e-9);
    EXPECT_EQ(verdict.factor, 1.0) << "as if the handout's";
}

TEST(Aperture, IsCentredOnTheEye) {
    for (const Vector3& off : {Vector3{0.2, 0.2, 0.0}, Vector3{0.0, -0.05, 0.0}}) {
        const ApertureVerdict verdict = judge([&](double x, double y) {
            return Vector3{x * kAmount, y * kAmount, 0.0} + off;
        });
        EXPECT_EQ(idOf(verdict.finding), "dof.off-centre") << off.y;
    }
    const double chance = 1.9 * kShortfall * kAmount;
    EXPECT_EQ(idOf(judge([&](double x, double y) {
                       return Vector3{x * kAmount + chance, y * kAmount, 0.0};
                   }).finding),
              "")
        << "within what chance can do";
}

TEST(Aperture, LiesInThePlaneOfTheEye) {
    for (const double depth : {1e-5, -1e-5})
        EXPECT_EQ(idOf(judge([=](double x, double y) {
                           return Vector3{x * kAmount, y * kAmount, x > 0.9 ? depth : 0.0};
                       }).finding),
                  "dof.disc");
}

TEST(Aperture, IsNoDiscNoDiamondAndNoCrowd) {
    const ApertureVerdict disc = judge([](double x, double y) {
        const double radius = std::sqrt(0.5 * (x + 1.0));
        const double angle = std::numbers::pi * y * 0.999;
        return Vector3{radius * std::cos(angle), radius * std::sin(angle), 0.0} * kAmount;
    });
    ASSERT_EQ(idOf(disc.finding), "dof.disc");
    EXPECT_NEAR(numberIn(*disc.finding, "shareInCorners"), 0.0, 0.05);
    EXPECT_EQ(idOf(judge([](double x, double y) {
                       return Vector3{0.5 * (x + y), 0.5 * (x - y), 0.0} * kAmount;
                   }).finding),
              "dof.disc");
    EXPECT_EQ(idOf(judge([](double x, double y) {
                       return Vector3{std::pow(x, 7.0), std::pow(y, 7.0), 0.0} * kAmount;
                   }).finding),
              "dof.disc");
}

/// Sixty rays of one pixel beside four hundred that fill the lens.
std::string judgeWithAPixel(const Vector3& reach, const Vector3& from) {
    LensByHand lens;
    fill(lens, [](double x, double y) { return Vector3{x * kAmount, y * kAmount, 0.0}; });
    LensPixel& pixel = lens.pixel();
    for (int i = 0; i < 60; ++i) {
        const int row = i / 8;
        pixel.rays.push_back(
            rayThrough({from.x + reach.x * (i % 8) / 7.0, from.y + reach.y * row / 7.0, 0.0},
                       {0.0, 0.0, 3.5}));
    }
    return idOf(checkAperture(lens.log).finding);
}

TEST(Aperture, IsUsedAsAWholeByEveryPixel) {
    EXPECT_EQ(judgeWithAPixel({0.39, 0.39, 0.0}, {-0.195, -0.195, 0.0}), "");
    EXPECT_EQ(judgeWithAPixel({0.21, 0.21, 0.0}, {-0.105, -0.105, 0.0}), "") << "half of it";
    EXPECT_EQ(judgeWithAPixel({0.19, 0.39, 0.0}, {-0.095, -0.195, 0.0}), "dof.disc");
    EXPECT_EQ(judgeWithAPixel({0.39, 0.19, 0.0}, {-0.195, -0.095, 0.0}), "dof.disc");
}

TEST(Aperture, IsUnevenAndNotUsedInPartWhereItsPointsCrowdInTheMiddle) {
    LensByHand lens;
    for (int i = 0; i < 20; ++i) {
        LensPixel& pixel = lens.pixel();
        for (int j = 0; j < 100; ++j) {
            const int row = j / 10;
            pixel.rays.push_back(
                rayThrough({0.004 * (j % 10 - 4.5), 0.004 * (row - 4.5), 0.0}, {0.0, 0.0, 3.5}));
        }
    }
    lens.pixel().rays = {rayThrough({-0.2, -0.2, 0.0}, {0.0, 0.0, 3.5}),
                         rayThrough({0.2, 0.2, 0.0}, {0.0, 0.0, 3.5})};
    // Repeated points count once.
    int next = 0;
    for (LensPixel& pixel : lens.log.pixels)
        for (LensRay& ray : pixel.rays)
            ray.origin.x += 1e-6 * ++next;
    const auto finding = checkAperture(lens.log).finding;
    ASSERT_EQ(idOf(finding), "dof.disc");
    EXPECT_NE(finding->message.find("evenly filled"), std::string::npos) << finding->message;
}

TEST(Aperture, IsNoLineAcrossTheSquare) {
    const auto onLine = [](double aside) {
        LensByHand lens;
        for (int i = 0; i < 10; ++i) {
            LensPixel& pixel = lens.pixel();
            for (int ray = 0; ray < 20; ++ray) {
                const double at = 0.2 * std::cos(1.7 * (20 * i + ray));
                const double off = ray % 2 == 0 ? aside : -aside;
                pixel.rays.push_back(rayThrough({at + off, at - off, 0.0}, {0.0, 0.0, 3.5}));
            }
        }
        const auto finding = checkAperture(lens.log).finding;
        return finding && finding->message.find("one straight line") != std::string::npos;
    };
    EXPECT_TRUE(onLine(0.0));
    EXPECT_TRUE(onLine(0.5e-4)) << "a thousandth of the half-width";
    EXPECT_FALSE(onLine(3e-4));
}

TEST(Aperture, IsNoLineInSomePixels) {
    const auto inPixels = [](int lines) {
        LensByHand lens;
        for (int pixel = 0; pixel < 24; ++pixel)
            fill(lens, [&](double x, double y) {
                return Vector3{x, pixel < lines ? x : y, 0.0} * kAmount;
            });
        return checkAperture(lens.log).finding;
    };
    EXPECT_FALSE(inPixels(2)) << "degenerate by chance";
    const auto finding = inPixels(3);
    ASSERT_EQ(idOf(finding), "dof.disc");
    EXPECT_NE(finding->message.find("some pixels"), std::string::npos) << finding->message;
}

TEST(Aperture, SaysNothingOfTwoRays) {
    LensByHand lens;
    lens.pixel().rays = {rayThrough({}, {0.0, 0.0, 1.0}),
                         rayThrough({0.9, 0.0, 0.0}, {0.0, 0.0, 1.0})};
    EXPECT_FALSE(checkAperture(lens.log).finding);
}

// Repeated points count once: forty points, ten times each, may fill less.
TEST(Aperture, CountsPointsThatComeAgainOnce) {
    LensByHand lens;
    for (int pixel = 0; pixel < 10; ++pixel)
        fill(lens, [](double x, double y) { return Vector3{x, y, 0.0} * (0.9 * kAmount); });
    EXPECT_EQ(idOf(checkAperture(lens.log).finding), "dof.aperture-size")
        << "400 points ten times are not 4000, but enough";
    LensByHand few;
    for (int pixel = 0; pixel < 10; ++pixel)
        fill(few, [](double x, double y) {
            return Vector3{std::round(3.0 * x) / 3.0, std::round(3.0 * y) / 3.0, 0.0} *
                   (0.7 * kAmount);
        });
    EXPECT_EQ(idOf(checkAperture(few.log).finding), "") << "49 points say little";
}

TEST(Aperture, MayBeScaledAlongOneAxisOnly) {
    constexpr int kSideOfMany = 60;
    const auto hintOf = [](double alongX, double alongY) {
        const ApertureVerdict verdict = judge(
            [=](double x, double y) {
                return Vector3{x * alongX, y * alongY, 0.0};
            },
            kSideOfMany);
        return verdict.finding ? verdict.finding->id + ": " + verdict.finding->hint : "none";
    };
    for (const auto& [x, y] : {std::pair{kAmount, 1.0}, std::pair{0.1, kAmount}}) {
        EXPECT_EQ(hintOf(x, y).rfind("dof.disc", 0), 0U);
        EXPECT_NE(hintOf(x, y).find("not scaled"), std::string::npos) << hintOf(x, y);
    }
    EXPECT_EQ(hintOf(0.14, kAmount).rfind("dof.disc", 0), 0U);
    EXPECT_EQ(hintOf(0.14, kAmount).find("not scaled"), std::string::npos) << hintOf(0.14, kAmount);
}

}  // namespace
}  // namespace ticker::tasks
