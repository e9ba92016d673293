#include <grader/tests/tasks/lens/LensByHand.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ticker::tasks {
namespace {

const double kPlane = raytracer::RenderSettings{}.dofFocalPlane;

/// Two pixels whose rays start at the corners of the lens and go to `target(focal point, origin)`.
template <typename Target>
std::optional<Finding> judgeFocusOf(const Target& target) {
    LensByHand lens;
    for (const Vector3& pinhole : {Vector3{0.1, 0.2, 1.0}, Vector3{-0.3, 0.1, 1.0}}) {
        LensPixel& pixel = lens.pixel(pinhole);
        for (const double x : {-0.2, 0.2})
            for (const double y : {-0.2, 0.2}) {
                const Vector3 origin{x, y, 0.0};
                pixel.rays.push_back(rayThrough(origin, target(pinhole * kPlane, origin)));
            }
    }
    return checkFocus(lens.log);
}

TEST(Focus, IsWhereThePinholeRayMeetsTheFocalPlane) {
    EXPECT_EQ(idOf(judgeFocusOf([](const Vector3& focal, const Vector3&) { return focal; })), "");
    LensByHand lens;
    const Vector3 focal = focalPointOf(lens.pixel({0.3, 0.4, 2.0}), lens.asked.settings);
    EXPECT_NEAR(focal.x, 0.15 * kPlane, 1e-12);
    EXPECT_NEAR(focal.z, kPlane, 1e-12);
}

TEST(Focus, MayBeMissedBySinglePrecisionOnly) {
    const auto missedBy = [](double distance) {
        LensByHand lens;
        LensRay ray = rayThrough({}, {0.0, 0.0, 1.0});
        ray.origin = {distance, 0.0, 0.0};
        lens.pixel().rays = {ray, rayThrough({0.1, 0.0, 0.0}, {0.0, 0.0, kPlane})};
        return checkFocus(lens.log);
    };
    EXPECT_FALSE(missedBy(1.9e-4));
    const auto missed = missedBy(2.1e-4);
    ASSERT_TRUE(missed);
    EXPECT_NEAR(numberIn(*missed, "farthestFromFocalPoint"), 2.1e-4, 1e-9);
}

TEST(CheckFocus, SaysOnWhichOtherPlaneTheRaysMeet) {
    const auto finding =
        judgeFocusOf([](const Vector3& focal, const Vector3&) { return focal * (4.0 / kPlane); });
    ASSERT_EQ(idOf(finding), "dof.focal-plane");
    EXPECT_NEAR(numberIn(*finding, "meetingZ"), 4.0, 1e-9);
    EXPECT_EQ(numberIn(*finding, "focalPlaneExpected"), kPlane);
    EXPECT_NE(finding->message.find("meet at z = 4 to 4"), std::string::npos) << finding->message;
    ASSERT_EQ(finding->plots.size(), 1U);
}

TEST(CheckFocus, SaysThatTheRaysMeetAtThatDistanceInsteadOfOnThatPlane) {
    const auto finding = judgeFocusOf(
        [](const Vector3& focal, const Vector3&) { return focal.normalised() * kPlane; });
    ASSERT_EQ(idOf(finding), "dof.focal-distance");
    EXPECT_NEAR(numberIn(*finding, "meetingZ"), kPlane / Vector3(-0.3, 0.1, 1.0).magnitude(), 1e-9);
}

TEST(CheckFocus, TellsAFocusBesideThePinholeRayFromOneOnAnotherPlane) {
    const auto beside = [](double distance) {
        return judgeFocusOf([=](const Vector3& focal, const Vector3&) {
            return focal + Vector3{0.0, 0.0, 1.0}.cross(focal).normalised() * distance;
        });
    };
    EXPECT_EQ(idOf(beside(0.05)), "dof.wrong");
    EXPECT_NE(beside(0.05)->hint.find("castRay(x, y)"), std::string::npos);
    EXPECT_EQ(idOf(beside(0.021)), "dof.wrong");
    EXPECT_EQ(idOf(beside(0.019)), "dof.focal-plane");
}

TEST(CheckFocus, SaysThatRaysAreParallelOrPassEachOther) {
    const auto parallel = judgeFocusOf([](const Vector3&, const Vector3& origin) {
        return origin + Vector3{0.1, 0.0, 1.0};
    });
    EXPECT_EQ(idOf(parallel), "dof.focal-plane");
    EXPECT_NE(parallel->message.find("parallel"), std::string::npos);
    EXPECT_EQ(numberIn(*parallel, "meetingZ"), 0.0);
    const auto passing = [](double distance) {
        LensByHand lens;
        // One ray passes above the other: the point nearest to both lies half-way between them.
        lens.pixel().rays = {rayThrough({-0.2, distance, 0.0}, {0.0, distance, 4.0}),
                             rayThrough({0.2, -distance, 0.0}, {0.0, -distance, 4.0})};
        return checkFocus(lens.log);
    };
    EXPECT_NE(passing(2.1e-3)->message.find("do not meet anywhere"), std::string::npos);
    EXPECT_NE(passing(2.1e-3)->message.find("by 0.0021"), std::string::npos);
    EXPECT_NE(passing(1.9e-3)->message.find("meet at z = 4"), std::string::npos)
        << passing(1.9e-3)->message;
}

TEST(CheckFocus, CountsRaysThatRunBackwards) {
    LensByHand lens;
    LensPixel& pixel = lens.pixel();
    for (const double x : {-0.2, 0.1, 0.2})
        pixel.rays.push_back(rayThrough({x, 0.0, 0.0}, {0.0, 0.0, kPlane}));
    EXPECT_FALSE(checkFocus(lens.log));
    pixel.rays.back().direction = -pixel.rays.back().direction;
    const auto one = checkFocus(lens.log);
    ASSERT_EQ(idOf(one), "dof.wrong");
    EXPECT_NE(one->message.find("1 of 3 leave the lens away from it"), std::string::npos);
    EXPECT_NE(one->hint.find("(focalPoint - lensPoint)"), std::string::npos);
}

TEST(CheckFocus, NamesTheCoordinatesThatWereNotDividedByZ) {
    const auto besides = [](const auto& change) {
        return judgeFocusOf([&](const Vector3& focal, const Vector3&) {
            Vector3 point = focal;
            change(point, focal.normalised() * kPlane);
            return point;
        });
    };
    const auto xy = besides([](Vector3& point, const Vector3& byLength) {
        point.x = byLength.x;
        point.y = byLength.y;
    });
    ASSERT_EQ(idOf(xy), "dof.wrong");
    EXPECT_NE(xy->message.find("x and y of the meeting point"), std::string::npos) << xy->message;
    EXPECT_NE(xy->hint.find("for all three coordinates"), std::string::npos);
    const auto z = besides([](Vector3& point, const Vector3& byLength) { point.z = byLength.z; });
    EXPECT_NE(z->message.find(": z of the meeting point"), std::string::npos) << z->message;
}

/// A pixel of a picture as wide as the handout's; its rays go to these places on the focal plane,
/// in units of the pixel's side.
LensLog logOf(LensByHand& lens, const std::vector<Vector3>& places) {
    const double side = 2.0 * std::tan(std::numbers::pi / 8.0) / lens.asked.settings.width * kPlane;
    LensPixel& pixel = lens.pixel();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Vector3 origin{i % 2 == 0 ? 0.2 : -0.1, i % 3 == 0 ? 0.1 : -0.2, 0.0};
        pixel.rays.push_back(rayThrough(origin, Vector3{0.0, 0.0, kPlane} + places[i] * side));
    }
    return lens.log;
}

TEST(Focus, MayBeAnywhereInThePixelWhereItWasSoInAFinePicture) {
    LensByHand inside;
    LensLog log = logOf(inside, {{0.49, 0.0, 0.0}, {-0.49, 0.49, 0.0}, {0.0, -0.49, 0.0}});
    EXPECT_TRUE(staysInPixels(log));
    EXPECT_EQ(idOf(checkFocus(log)), "dof.focal-plane") << "no fine picture was asked for";
    log.mayAntialias = true;
    const auto smooth = checkFocus(log);
    ASSERT_EQ(idOf(smooth), "dof.antialiased");
    EXPECT_EQ(smooth->severity, Severity::warn);

    LensByHand outside;
    log = logOf(outside, {{0.52, 0.0, 0.0}, {-0.49, 0.0, 0.0}});
    log.mayAntialias = true;
    EXPECT_FALSE(staysInPixels(log));
    EXPECT_EQ(idOf(checkFocus(log)), "dof.focal-plane");
}

}  // namespace
}  // namespace ticker::tasks
