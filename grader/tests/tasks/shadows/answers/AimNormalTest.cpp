// Aims that keep to one side of the surface's normal.
#include <grader/tasks/shadows/answers/AimNormal.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tests/tasks/shadows/ShadowByHand.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace ticker::tasks {
namespace {

using Purpose = ShadowQuestion::Purpose;
/// Turns a random point of the unit ball into an aim, in radii.
using Aim = std::function<Vector3(const Vector3& inBall, const Vector3& normal)>;

Vector3 drawInBall(Draw& draw) {
    const auto one = [&] { return draw.between(-1.0, 1.0); };
    Vector3 point{one(), one(), one()};
    while (point.magnitude() > 1.0)
        point = {one(), one(), one()};
    return point;
}

/// Three far lights that do not stand along the normal, with 400 rays each.
void castFar(ShadowByHand& made, const Aim& aim) {
    Draw draw{7, 1};
    for (const Vector3& light :
         {Vector3{80.0, 90.0, 0.0}, Vector3{0.0, 90.0, 70.0}, Vector3{-60.0, 80.0, -40.0}}) {
        made.ask(Purpose::farLight, {light});
        for (int i = 0; i < 40; ++i) {
            made.point();
            for (int ray = 0; ray < 10; ++ray)
                made.cast(light + aim(drawInBall(draw), {0.0, 1.0, 0.0}) * 0.4);
        }
    }
}

Vector3 turned(const Vector3& inBall, const Vector3& normal) {
    return inBall.dot(normal) < 0.0 ? inBall * -1.0 : inBall;
}

TEST(LeanToNormal, IsThreeEighthsForAHalfBall) {
    const auto leanOf = [](const Aim& aim) {
        ShadowByHand made;
        castFar(made, aim);
        return leanToNormal(made.logs().farLight);
    };
    EXPECT_NEAR(leanOf([](const Vector3& p, const Vector3&) { return p; }), 0.0, 0.06);
    EXPECT_EQ(leanOf([](const Vector3& p, const Vector3&) {
                  return turned(p, {1.0, 0.0, 0.0});
              }),
              0.0)
        << "another half, wherever the normal points";
    EXPECT_NEAR(leanOf(turned), 0.375, 0.06);
    EXPECT_NEAR(leanOf([](const Vector3& p, const Vector3& n) { return turned(p, n * -1.0); }),
                -0.375, 0.06);
    EXPECT_EQ(leanToNormal({}), 0.0);
}

TEST(CheckAims, SaysOnWhichSideOfTheNormalHalfABallLies) {
    const auto toldOf = [](const Aim& aim, std::size_t distinct = 1200) {
        ShadowByHand made;
        castFar(made, aim);
        AimVerdict aims;  // of no known shape
        aims.lines = 1200;
        aims.distinct = distinct;
        aims.widest = 1.0;
        const auto finding = checkAims(made.logs(), aims);
        EXPECT_EQ(idOf(finding), "shadow.not-a-ball");
        return finding->message + finding->hint;
    };
    EXPECT_NE(toldOf(turned).find("one side of it, that of the surface's normal N"),
              std::string::npos);
    EXPECT_NE(toldOf(turned).find("turn no offset round"), std::string::npos);
    EXPECT_NE(toldOf([](const Vector3& p, const Vector3& n) {
                  return turned(p, n * -1.0);
              }).find("opposite to the surface's normal N"),
              std::string::npos);
    EXPECT_NE(toldOf([](const Vector3& p, const Vector3& n) {
                  return p * 0.5 + n * 0.5;
              }).find("add no N"),
              std::string::npos);
    const Aim rod = [](const Vector3& p, const Vector3&) { return Vector3{p.y, p.y, p.y}; };
    EXPECT_NE(toldOf(turned, 199).find("another shape"), std::string::npos);
    EXPECT_NE(toldOf(rod).find("another shape"), std::string::npos);
}

}  // namespace
}  // namespace ticker::tasks
