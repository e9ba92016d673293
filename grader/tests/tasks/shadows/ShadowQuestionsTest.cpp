// Properties that the questions of T2.1 have whatever the seed, tested for three seeds or more.
#include <grader/tasks/shadows/questions/ShadowDraws.h>
#include <grader/tasks/shadows/questions/ShadowQuestions.h>
#include <grader/tasks/support/Draw.h>
#include <grader/tasks/support/Surfaces.h>

#include <questions/RayGeometry.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ticker::tasks {
namespace {

using Purpose = ShadowQuestion::Purpose;

const std::vector<std::vector<ShadowQuestion>>& drawn() {
    static const std::vector<std::vector<ShadowQuestion>> all{
        drawShadowQuestions(1), drawShadowQuestions(2), drawShadowQuestions(3)};
    return all;
}

template <typename Test>
void forEach(Purpose purpose, const Test& test) {
    int found = 0;
    for (const std::vector<ShadowQuestion>& questions : drawn())
        for (const ShadowQuestion& question : questions)
            if (question.purpose == purpose) test(question), ++found;
    EXPECT_GE(found, 3);
}

Vector3 lightOf(const ShadowQuestion& drawn, std::size_t light = 0) {
    return drawn.question.scene.pointLights.at(light).position();
}

/// How large a ball around the light must be visible completely or not at all, in radii of the
/// light.
double marginOf(Purpose purpose) {
    constexpr double kMargin = 1.25;
    // The nearest plane before a light is 1.2 radii from its centre and leans by 0.1.
    constexpr double kMarginOfHemmedIn = 1.08;
    const bool isHemmedIn = purpose == Purpose::beyondLight || purpose == Purpose::nearLight;
    return isHemmedIn ? kMarginOfHemmedIn : kMargin;
}

/// Expects that a ball around the light is visible as the zone says: completely or not at all.
/// Nothing is expected in the penumbra.
void expectZone(const ShadowQuestion& drawn, std::size_t at, std::size_t light) {
    const Surfaces surfaces{drawn.question.scene};
    const probe::LitPoint& point = drawn.question.points[at];
    const Zone zone = drawn.zones[at][light];
    if (zone == Zone::penumbra) return;
    const double radius = drawn.question.settings.lightSize * marginOf(drawn.purpose);
    Draw draw{at, 9};
    int open = 0;
    constexpr int kRays = 100;
    for (int i = 0; i < kRays; ++i) {
        const Vector3 start = point.position + point.normal * 1e-4;
        const Vector3 towards = lightOf(drawn, light) + draw.direction() * radius - start;
        const double reach = towards.magnitude();
        open += surfaces.sightAlong(start, towards / reach, reach) != Sight::blocked ? 1 : 0;
    }
    EXPECT_EQ(open, zone == Zone::lit ? kRays : 0) << at;
}

TEST(ShadowQuestions, SayRightlyWhatIsLitAndWhatIsNot) {
    for (const std::vector<ShadowQuestion>& questions : drawn())
        for (const ShadowQuestion& question : questions) {
            ASSERT_EQ(question.zones.size(), question.question.points.size());
            if (question.purpose == Purpose::farLight) continue;
            for (std::size_t i = 0; i < question.zones.size(); ++i)
                for (std::size_t light = 0; light < question.zones[i].size(); ++light)
                    expectZone(question, i, light);
        }
}

TEST(ShadowQuestions, HaveRoomForEightTimesTheRaysAndPointsOnTheirSurfaces) {
    for (const std::vector<ShadowQuestion>& questions : drawn())
        for (const ShadowQuestion& question : questions) {
            const probe::IlluminateQuestion& asked = question.question;
            const bool isMixed =
                question.purpose == Purpose::mixed || question.purpose == Purpose::mixedNear;
            const std::size_t capacity = 8 * asked.points.size() * asked.scene.pointLights.size() *
                                         static_cast<std::size_t>(asked.settings.shadowRayCount);
            // Some mixed scenes have no light.
            EXPECT_EQ(asked.eventCapacity, std::max<std::size_t>(capacity, isMixed ? 64 : 0));
            const Surfaces surfaces{asked.scene};
            for (const probe::LitPoint& point : asked.points) {
                EXPECT_LT(surfaces.distanceToNearest(point.position), 1e-9);
                const Vector3 towards = point.viewer - point.position;
                EXPECT_EQ(towards.dot(point.normal) > 0.0, question.purpose != Purpose::backSide);
                const bool fromLens = point.viewer.z == 0.0;
                const bool fromAfar =
                    question.purpose == Purpose::farLight && towards.magnitude() > 100.0;
                EXPECT_TRUE(fromLens || fromAfar ||
                            (towards.magnitude() > (isMixed ? 1.0 : 3.0) &&
                             towards.magnitude() < (isMixed ? 15.0 : 5.0)));
            }
        }
}

// Otherwise rays of a right submission would be counted for another light.
TEST(ShadowQuestions, HaveNoLightWhoseRimIsNearerToAnothersCentreInAngle) {
    Draw draw{5, 9};
    for (std::uint64_t seed = 1; seed <= 80; ++seed)
        for (const ShadowQuestion& question : drawShadowQuestions(seed)) {
            const auto& lights = question.question.scene.pointLights;
            if (question.purpose == Purpose::lightsInLine) continue;
            for (const probe::LitPoint& point : question.question.points)
                for (std::size_t light = 0; light < lights.size(); ++light)
                    for (int i = 0; i < 12; ++i) {
                        const Vector3 start = point.position + point.normal * 1e-3;
                        const Vector3 rim = draw.direction() * question.question.settings.lightSize;
                        const Vector3 way = lights[light].position() + rim - start;
                        EXPECT_EQ(
                            raytracer::questions::nearestLight(lights, start, way.normalised()),
                            light)
                            << static_cast<int>(question.purpose) << ", seed " << seed;
                    }
        }
}

int countZones(const ShadowQuestion& question, Zone zone) {
    return static_cast<int>(
        std::count(question.zones.begin(), question.zones.end(), std::vector<Zone>{zone}));
}

TEST(ShadowQuestions, OfOneLightHaveAllThreeZonesAndPointsOnTheBall) {
    for (const Purpose purpose : {Purpose::oneLight, Purpose::otherSettings, Purpose::oddCount})
        forEach(purpose, [&](const ShadowQuestion& question) {
            if (question.question.scene.spheres.empty()) return;  // a light of another size
            const int each = purpose == Purpose::oneLight ? 12 : 6;
            EXPECT_EQ(countZones(question, Zone::lit), each + 6);
            EXPECT_EQ(countZones(question, Zone::umbra), each);
            EXPECT_EQ(countZones(question, Zone::penumbra), each);
            const auto& points = question.question.points;
            EXPECT_EQ(std::count_if(points.begin(), points.end(),
                                    [](const auto& point) { return point.viewer.z == 0.0; }),
                      3 * each / 2);
        });
}

TEST(ShadowQuestions, OfOneLightHaveTheBallBetweenFloorAndLight) {
    std::vector<double> heights;
    forEach(Purpose::oneLight, [&](const ShadowQuestion& question) {
        const auto& scene = question.question.scene;
        const raytracer::SphereDescription& ball = scene.spheres.at(0);
        const raytracer::PlaneDescription& floor = scene.planes.at(0);
        heights.push_back((ball.centre - floor.point).dot(floor.normal));
        EXPECT_TRUE(std::abs(heights.back() / 1.7 - 1.0) < 0.21 ||
                    std::abs(heights.back() / 20.0 - 1.0) < 0.21);
        const Vector3 up = lightOf(question) - ball.centre;
        EXPECT_TRUE(up.magnitude() > 3.0 && up.magnitude() < 4.0);
        EXPECT_GT(up.normalised().dot(floor.normal), std::cos(0.5) - 1e-9);
        for (const probe::LitPoint& point : question.question.points) {
            if (point.object != 0) continue;
            const Vector3 beside = point.position - ball.centre;
            EXPECT_NEAR(beside.magnitude(), ball.radius, 1e-9);
            EXPECT_GT(beside.dot(up), 0.0) << "faces the light";
        }
    });
    EXPECT_LT(*std::min_element(heights.begin(), heights.end()), 2.1);
    EXPECT_GT(*std::max_element(heights.begin(), heights.end()), 15.0);
}

TEST(ShadowQuestions, OfEightLightsHaveThemInSightAndFarApart) {
    forEach(Purpose::eightLights, [](const ShadowQuestion& question) {
        const auto& scene = question.question.scene;
        ASSERT_EQ(scene.pointLights.size(), 8U);
        EXPECT_EQ(question.question.points.size(), 18U);
        for (const probe::LitPoint& point : question.question.points)
            for (std::size_t i = 0; i < 8; ++i) {
                const Vector3 one = (lightOf(question, i) - point.position).normalised();
                const Vector3 next = (lightOf(question, (i + 1) % 8) - point.position).normalised();
                EXPECT_GT(one.dot(point.normal), 0.4);
                EXPECT_LT(one.dot(next), std::cos(0.5));
            }
    });
}

TEST(ShadowQuestions, OfThreeLightsHaveThemRoundTheFloorAndBallsBeforeTwoAndBehindTheNearest) {
    forEach(Purpose::severalLights, [](const ShadowQuestion& question) {
        const auto& scene = question.question.scene;
        const Vector3 foot = scene.planes.at(0).point;
        const Vector3 up = scene.planes[0].normal;
        ASSERT_EQ(scene.pointLights.size(), 3U);
        ASSERT_EQ(scene.spheres.size(), 3U);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vector3 one = lightOf(question, i) - foot;
            EXPECT_TRUE(i == 2 ? one.magnitude() > 5.0 && one.magnitude() < 5.3
                               : one.magnitude() > 8.0 && one.magnitude() < 9.0);
            const double rise = one.normalised().dot(up);
            EXPECT_TRUE(rise > 1.0 / std::hypot(1.0, 1.7) && rise < 1.0 / std::hypot(1.0, 1.3));
            const Vector3 other = lightOf(question, (i + 1) % 3) - foot;
            const Vector3 flat = one - up * one.dot(up);
            const Vector3 otherFlat = other - up * other.dot(up);
            EXPECT_NEAR(flat.normalised().dot(otherFlat.normalised()), -0.5, 1e-9);
            const Vector3 ball = scene.spheres[i].centre - foot;
            EXPECT_NEAR(ball.normalised().dot(one.normalised()), 1.0, 1e-9);
            if (i == 2) {
                const double gap = ball.magnitude() - scene.spheres[i].radius - one.magnitude();
                EXPECT_TRUE(gap > 1.5 * 0.4 && ball.magnitude() < 7.0);
            } else {
                EXPECT_TRUE(ball.magnitude() > 1.6 && ball.magnitude() < 2.2);
            }
        }
        double farthest = 0.0;
        for (std::size_t i = 0; i < question.question.points.size(); ++i) {
            const double away = (question.question.points[i].position - foot).magnitude();
            EXPECT_TRUE(i >= 6 || away < 0.06 * 1.4143);
            farthest = std::max(farthest, away);
        }
        EXPECT_TRUE(farthest > 0.4 && farthest < 1.0);
        EXPECT_EQ(question.question.points.size(), 24U);
    });
}

TEST(ShadowQuestions, OfWhatIsBehindTheLightHaveABallThere) {
    forEach(Purpose::beyondLight, [](const ShadowQuestion& question) {
        const auto& scene = question.question.scene;
        const Vector3 foot = scene.planes.at(0).point;
        const Vector3 towards = lightOf(question) - foot;
        const Vector3 behind = scene.spheres.at(0).centre - lightOf(question);
        EXPECT_TRUE(towards.magnitude() > 3.0 && towards.magnitude() < 4.0);
        EXPECT_NEAR(behind.normalised().dot(towards.normalised()), 1.0, 1e-9);
        const double gap = behind.magnitude() - scene.spheres[0].radius;
        EXPECT_TRUE(gap > 0.8 && gap < 1.6) << gap;
        ASSERT_EQ(question.question.points.size(), 8U);
        for (const probe::LitPoint& point : question.question.points)
            EXPECT_LT((point.position - foot).magnitude(), 0.4 * 1.4143);
    });
}

TEST(ShadowQuestions, OfObjectsInLineHaveEightPointsInShadowAndFourInLightForEverySeed) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed)
        for (const ShadowQuestion& question : drawShadowQuestions(seed)) {
            if (question.purpose != Purpose::inLine) continue;
            ASSERT_EQ(question.zones.size(), 12U);
            for (std::size_t i = 0; i < 12; ++i)
                EXPECT_EQ(question.zones[i][0], i < 8 ? Zone::umbra : Zone::lit)
                    << "seed " << seed << ", point " << i;
        }
}

TEST(ShadowQuestions, OfObjectsInLineHaveTwoBeforeTheLightBetweenTwoBehindIt) {
    forEach(Purpose::inLine, [](const ShadowQuestion& question) {
        ASSERT_EQ(question.question.points.size(), 12U);
        const auto& scene = question.question.scene;
        ASSERT_EQ(scene.spheres.size(), 4U);
        for (std::size_t i = 0; i < 8; ++i) {
            const Vector3 start = question.question.points[i].position;
            const Vector3 way = lightOf(question) - start;
            const double reach = way.magnitude();
            for (std::size_t sphere = 0; sphere < 4; ++sphere) {
                raytracer::SceneDescription alone;
                alone.spheres = {scene.spheres[sphere]};
                const Surfaces surfaces{alone};
                const bool before = sphere == 1 || sphere == 2;
                EXPECT_EQ(surfaces.sightAlong(start, way / reach, reach),
                          before ? Sight::blocked : Sight::open);
                EXPECT_EQ(surfaces.sightAlong(start, way / reach, 1e9), Sight::blocked);
            }
        }
    });
}

TEST(ShadowQuestions, OfTheHorizonHaveAPartOfTheLightBelowTheFloor) {
    bool isSunken = false;
    forEach(Purpose::horizon, [&](const ShadowQuestion& question) {
        const double size = question.question.settings.lightSize;
        for (const probe::LitPoint& point : question.question.points) {
            const double height = (lightOf(question) - point.position).dot(point.normal);
            EXPECT_GE(std::abs(height), 0.15 * size - 1e-9);
            EXPECT_LE(std::abs(height), 0.25 * size + 1e-9);
            if (height < 0.0) isSunken = true;
        }
    });
    EXPECT_TRUE(isSunken);
}

// Rays to the light's lower edge above the floor arrive, rays to its upper edge meet the ball.
TEST(ShadowQuestions, OfTheHorizonBehindABallShowAStripOfTheLight) {
    bool hasBall = false;
    forEach(Purpose::horizon, [&](const ShadowQuestion& question) {
        const auto& scene = question.question.scene;
        if (scene.spheres.empty()) return;
        hasBall = true;
        const Surfaces surfaces{scene};
        for (const probe::LitPoint& point : question.question.points) {
            ASSERT_EQ(point.object, 1);
            const Vector3 start = rayStart(point.position, point.normal);
            const Vector3 light = lightOf(question);
            const double height = (light - point.position).dot(point.normal);
            const auto sightAt = [&](double above) {
                const Vector3 towards = light + point.normal * (above - height) - start;
                const double reach = towards.magnitude();
                return surfaces.sightAlong(start, towards / reach, reach);
            };
            const double size = question.question.settings.lightSize;
            EXPECT_EQ(sightAt(0.1 * size), Sight::open);
            EXPECT_EQ(sightAt(0.9 * (height + size)), Sight::blocked);
            EXPECT_EQ(sightAt(-0.1 * size), Sight::blocked);
        }
    });
    EXPECT_TRUE(hasBall);
}

TEST(ShadowQuestions, OfALowLightHaveViewersThatSeeNoHighlight) {
    forEach(Purpose::lowLight, [](const ShadowQuestion& question) {
        ASSERT_EQ(question.question.points.size(), 10U);
        for (const probe::LitPoint& point : question.question.points) {
            const Vector3 towards = (lightOf(question) - point.position).normalised();
            const Vector3 viewer = (point.viewer - point.position).normalised();
            const Vector3 eye = (-point.position).normalised();
            EXPECT_LT(towards.reflectIn(point.normal).dot(viewer), -0.5);
            EXPECT_LT(towards.reflectIn(point.normal).dot(eye), -0.5);
            EXPECT_GT(viewer.dot(point.normal), 0.2);
            EXPECT_GT(towards.dot(point.normal), 0.3);
        }
    });
}

TEST(ShadowQuestions, OfANearLightHaveAPlaneJustOutsideOfItsBall) {
    forEach(Purpose::nearLight, [](const ShadowQuestion& question) {
        const auto& scene = question.question.scene;
        const double size = question.question.settings.lightSize;
        ASSERT_EQ(question.question.points.size(), 8U);
        ASSERT_EQ(scene.planes.size(), 2U);
        const raytracer::PlaneDescription& plane = scene.planes[1];
        EXPECT_GT(std::abs((lightOf(question) - plane.point).dot(plane.normal)), 1.19 * size);
        for (const probe::LitPoint& point : question.question.points) {
            const Vector3 way = lightOf(question) - point.position;
            const double hit = (plane.point - point.position).dot(plane.normal) /
                               way.normalised().dot(plane.normal);
            EXPECT_TRUE(hit < way.magnitude() - 1.19 * size && hit > way.magnitude() - 1.4 * size)
                << way.magnitude() - hit;
            EXPECT_GT(hit, 0.97 * way.magnitude());
        }
    });
}

TEST(ShadowQuestions, OfAWallHaveAPointOnEitherSideInTurn) {
    std::vector<double> facing;
    forEach(Purpose::planeShadow, [&](const ShadowQuestion& question) {
        ASSERT_EQ(question.zones.size(), 8U);
        for (std::size_t i = 0; i < 8; ++i)
            EXPECT_EQ(question.zones[i][0], i % 2 == 0 ? Zone::lit : Zone::umbra) << i;
        const auto& scene = question.question.scene;
        const Vector3 towards = lightOf(question) - scene.planes.at(0).point;
        const double above = towards.dot(scene.planes[0].normal);
        EXPECT_TRUE(above > 2.0 && above < 4.0);
        const double beside = (towards - scene.planes[0].normal * above).magnitude();
        EXPECT_TRUE(beside > 2.0 && beside < 4.0);
    });
}

TEST(ShadowQuestions, OfFarLightsLookAlongThreeAxes) {
    for (const std::vector<ShadowQuestion>& questions : drawn()) {
        std::vector<Vector3> axes;
        for (const ShadowQuestion& question : questions) {
            if (question.purpose != Purpose::farLight) continue;
            const raytracer::PlaneDescription& floor = question.question.scene.planes.at(0);
            const Vector3 towards = lightOf(question) - floor.point;
            EXPECT_TRUE(towards.magnitude() > 100.0 && towards.magnitude() < 140.0);
            axes.push_back(towards.normalised());
            EXPECT_GT(axes.back().dot(floor.normal), std::cos(0.9) - 1e-9);
            EXPECT_LT(axes.back().dot(floor.normal), std::cos(0.65) + 1e-9);
            ASSERT_EQ(question.question.points.size(), 67U);
            for (const probe::LitPoint& point : question.question.points)
                EXPECT_LT((point.position - floor.point).magnitude(), 1.5e-4);
        }
        ASSERT_EQ(axes.size(), 3U);
        EXPECT_NEAR(std::abs(axes[0].cross(axes[1]).dot(axes[2])), 1.0, 1e-9);
    }
}

double sineBetween(const Vector3& a, const Vector3& b) {
    return a.normalised().cross(b.normalised()).magnitude();
}

// Three of four viewers stand far aside. Of 67 points fewer than 34 have one with a chance below
// 1e-5.
TEST(ShadowQuestions, OfFarLightsHaveViewersFarAsideFromPointAndLight) {
    for (const std::vector<ShadowQuestion>& questions : drawn())
        for (const ShadowQuestion& question : questions) {
            if (question.purpose != Purpose::farLight) continue;
            int aside = 0;
            for (const probe::LitPoint& point : question.question.points) {
                const Vector3 way = lightOf(question) - point.position;
                const Vector3 towards = point.viewer - point.position;
                EXPECT_GT(towards.normalised().dot(point.normal), 0.099);
                if (sineBetween(towards, way) > 0.7 &&
                    sineBetween(point.viewer - lightOf(question), way) > 0.7)
                    ++aside;
            }
            EXPECT_GE(aside, 34);
        }
}

int channelsOf(const ColourRGB& colour) {
    return (colour.r > 0.0 ? 1 : 0) + (colour.g > 0.0 ? 1 : 0) + (colour.b > 0.0 ? 1 : 0);
}

TEST(ShadowQuestions, OfPureColoursHaveEachChannelAloneAndLightFromEveryLight) {
    forEach(Purpose::pureColours, [](const ShadowQuestion& question) {
        const auto& scene = question.question.scene;
        ASSERT_EQ(question.question.points.size(), 9U);
        const bool ofLights = scene.spheres.empty();
        ColourRGB all;
        for (const raytracer::PointLight& light : scene.pointLights) {
            EXPECT_EQ(channelsOf(light.colour()), ofLights ? 1 : 3);
            all += light.colour();
        }
        for (const raytracer::SphereDescription& ball : scene.spheres) {
            EXPECT_EQ(channelsOf(ball.material.colour), 1);
            all += ball.material.colour;
        }
        EXPECT_EQ(channelsOf(all), 3);
        for (const probe::LitPoint& point : question.question.points)
            for (std::size_t light = 0; light < scene.pointLights.size(); ++light)
                EXPECT_GT(
                    (lightOf(question, light) - point.position).normalised().dot(point.normal),
                    0.3);
    });
}

TEST(ShadowQuestions, OfAnOddNumberAskForFewerRaysThanTheHandout) {
    forEach(Purpose::oddCount, [](const ShadowQuestion& question) {
        const int rays = question.question.settings.shadowRayCount;
        EXPECT_LT(rays, raytracer::RenderSettings{}.shadowRayCount);
        for (const int group : {2, 3, 5})
            EXPECT_NE(rays % group, 0);
    });
}

}  // namespace
}  // namespace ticker::tasks
