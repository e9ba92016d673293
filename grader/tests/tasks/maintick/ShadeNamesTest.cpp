#include <grader/tests/tasks/maintick/ShadesByTable.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <utility>

namespace ticker::tasks {
namespace {

TEST(ShadeNames, SayNothingOfRightShadows) {
    const TaskJudgement judgement = judgeLooks({});
    EXPECT_EQ(judgement.state, TaskState::passed);
    EXPECT_TRUE(judgement.findings.empty());
}

TEST(ShadeNames, NameWhatIsWrongInOnePlaceAlone) {
    using enum Look;
    expectNamed({{{{Occluder::itself, dark}}, "shade.acne"},
                 {{{Occluder::near, lit}}, "shade.bias"},
                 {{{Occluder::beyond, dark}}, "shade.beyond-light"},
                 {{{Occluder::farBeyond, dark}}, "shade.distance"},
                 {{{Occluder::close, lit}}, "shade.distance"},
                 {{{Occluder::between, lit}}, "shade.distance"},
                 {{{Occluder::ofFirstLight, lit}}, "shade.lights"},
                 {{{Occluder::ofSecondLight, lit}}, "shade.lights"},
                 {{{Occluder::wall, lit}}, "shade.wrong", "Planes cast shadows"},
                 {{{Occluder::beforeAndBeyond, lit}}, "shade.wrong", "What stands behind"},
                 {{{Occluder::aroundLight, lit}}, "shade.wrong", "sphere around the light"},
                 {{{Occluder::aroundPoint, lit}}, "shade.wrong", "sphere around P"},
                 {{{Occluder::aroundBoth, dark}}, "shade.beyond-light", "around both P"},
                 {{{Occluder::grazing, dark}}, "shade.wrong", "Low light"},
                 {{{Occluder::atPointOfFar, lit}}, "shade.distance", "95 away"},
                 {{{Occluder::atFarLight, lit}}, "shade.distance", "95 away"},
                 {{{Occluder::beyondFarLight, dark}}, "shade.distance", "95 away"},
                 {{{Occluder::backwards, dark}}, "shade.wrong"}});
}

TEST(ShadeNames, SayThatLowLightIsLostEvenWhereThePointFloats) {
    Habits high;
    high.lowest = 0.045;
    expectNamed({{{}, "shade.wrong", "Low light", high}});
    const auto findings = judgeLooks({}, high).findings;
    EXPECT_NE(findings.at(0).message.find("got the same"), std::string::npos)
        << findings.at(0).message;
    high.lowest = 0.5;
    EXPECT_TRUE(judgeLooks({}, high).findings.empty()) << "other light is lost, too, as by M2";
    high.lowest = 0.019;
    EXPECT_TRUE(judgeLooks({}, high).findings.empty());
}

TEST(ShadeNames, LookAtSeveralPlacesAtOnce) {
    using enum Look;
    expectNamed(
        {{{{Occluder::near, lit}, {Occluder::farBeyond, dark}}, "shade.distance"},
         {{{Occluder::near, lit}, {Occluder::between, lit}}, "shade.distance"},
         {{{Occluder::near, lit}, {Occluder::close, lit}}, "shade.bias"},
         {{{Occluder::beyond, dark}, {Occluder::close, lit}}, "shade.distance"},
         {{{Occluder::beyond, dark}, {Occluder::itself, dark}}, "shade.acne"},
         {{{Occluder::before, lit}, {Occluder::itself, dark}}, "shade.acne"},
         {{{Occluder::before, lit}, {Occluder::between, lit}}, "shade.wrong", "comes out lit"},
         {{{Occluder::before, lit}, {Occluder::backwards, dark}}, "shade.wrong", "comes out lit"},
         {with(hidden(lit), {{Occluder::backwards, dark}, {Occluder::beyond, dark}}),
          "shade.beyond-light"}});
}

TEST(ShadeNames, NameWhatAllHiddenPlacesShow) {
    using enum Look;
    const Looks allDark{{Occluder::beyond, dark},    {Occluder::farBeyond, dark},
                        {Occluder::backwards, dark}, {Occluder::itself, dark},
                        {Occluder::grazing, dark},   {Occluder::beyondFarLight, dark},
                        {Occluder::aroundBoth, dark}};
    expectNamed({{hidden(lit), "shade.none"},
                 {with(hidden(lit), {{Occluder::beyond, dark}}), "shade.beyond-light",
                  "the wrong way round"},
                 {with(hidden(lit), allDark), "shade.inverted"},
                 {hidden(black), "shade.ambient"},
                 {hidden(specular), "shade.specular"},
                 {hidden(diffuse), "shade.diffuse"}});
}

TEST(ShadeNames, SayThatAmbientLightIsAddedAgainInShadow) {
    using enum Look;
    const auto withAcne = [](Looks looks) {
        return with(std::move(looks), {{Occluder::itself, dark}});
    };
    expectNamed({{hidden(ambientAgain), "shade.wrong", "more than once"},
                 {hidden(ambientOfAll), "shade.wrong", "more than once"},
                 {withAcne(hidden(ambientAgain)), "shade.wrong", "more than once"},
                 {with(hidden(ambientAgain), {{Occluder::before, black}}), "shade.ambient"},
                 {{{Occluder::backwards, ambientAgain}}, "shade.wrong", "Cast Ray"}});
}

TEST(ShadeNames, SayWhereRaysLeadThatMissTheLight) {
    using enum Look;
    Habits away;
    away.towardsLight = -1.0;
    Habits aside;
    aside.besideLight = {3.0, 4.0, 5.0};
    Habits nowhere;
    nowhere.besideLight.x = std::numeric_limits<double>::quiet_NaN();
    const Looks looks{{Occluder::itself, dark}};
    expectNamed({{looks, "shade.wrong", "leaves away from the light", away},
                 {looks, "shade.wrong", "in another direction", aside},
                 {looks, "shade.wrong", "in another direction", nowhere}});
}

TEST(ShadeNames, SayThatRaysStartFarFromThePoint) {
    using enum Look;
    const auto startingAt = [](const Vector3& away, double alongNormal) {
        Habits habits;
        habits.awayFromPoint = away;
        habits.alongNormal = alongNormal;
        return habits;
    };
    const Looks looks{{Occluder::before, lit}, {Occluder::itself, dark}};
    const Looks anyLooks{{Occluder::wall, lit}};
    const char* const farAlong = "The ray starts far from P";
    const char* const elsewhere = "what the call hands to isShadowed, (scene, light, P, N)";
    expectNamed({{looks, "shade.bias", farAlong, startingAt({}, 1.0)},
                 {looks, "shade.bias", farAlong, startingAt({}, -0.4)},
                 {anyLooks, "shade.bias", farAlong, startingAt({}, 1.0)},
                 {looks, "shade.wrong", elsewhere, startingAt({20.0, -30.0, 7.0}, 0.0)},
                 {anyLooks, "shade.wrong", elsewhere, startingAt({20.0, -30.0, 7.0}, 0.0)},
                 {anyLooks, "shade.wrong", "Planes cast shadows", startingAt({}, 0.29)}});
    Habits unseen = startingAt({}, 1.0);
    unseen.kind = probe::Event::Kind::traceBegan;
    expectNamed({{anyLooks, "shade.wrong", "Planes cast shadows", unseen}});
}

TEST(ShadeNames, SayThatARayFromTheLightMeetsTheSurfaceOfThePoint) {
    Habits fromLight;
    fromLight.isFromLight = true;
    const Looks acne{{Occluder::itself, Look::dark}};
    expectNamed({{acne, "shade.acne", "Cast it the other way", fromLight},
                 {acne, "shade.acne", "Start the ray a little above the surface"},
                 {{{Occluder::wall, Look::lit}}, "shade.wrong", "Planes cast", fromLight}});
}

TEST(ShadeNames, SayThatTheOwnSurfaceHidesWhatStandsBehindIt) {
    Habits leaks;
    leaks.leaks = true;
    expectNamed({{{}, "shade.wrong", "below its surface", leaks},
                 {{{Occluder::beyond, Look::dark}}, "shade.wrong", "Cast Ray", leaks}});
}

TEST(ShadeNames, DescribeAPlaceThatShowsTheMistake) {
    const auto findings =
        judgeLooks({{Occluder::beyond, Look::dark}, {Occluder::itself, Look::dark}}).findings;
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_NE(findings[0].message.find("nothing but the surface"), std::string::npos)
        << findings[0].message;
}

TEST(ShadeNames, LookAtASurfaceItselfFromItsOwnSide) {
    for (std::uint64_t seed = 0; seed < 50; ++seed)
        for (const ShadeCase& shade : maintick::drawShadeCases(seed)) {
            if (shade.place != Occluder::itself) continue;
            for (const LitSetup* setup : {&shade.free, &shade.asked, &shade.without})
                EXPECT_GT((setup->O - setup->P).normalised().dot(setup->N), 0.45) << seed;
        }
}

TEST(ShadeNames, MeasureWhereRaysNearThePointStart) {
    using Kind = probe::Event::Kind;
    const auto idFrom = [](double away, Kind kind) {
        Habits habits;
        habits.kind = kind;
        habits.awayFromPoint = {0.0, away, 0.0};
        const auto findings = judgeLooks({}, habits).findings;
        return findings.empty() ? std::string{} : findings[0].id;
    };
    EXPECT_EQ(idFrom(1.09e-3, Kind::rayCast), "");
    EXPECT_EQ(idFrom(1.11e-3, Kind::rayCast), "shade.bias");
    EXPECT_EQ(idFrom(0.29, Kind::rayCast), "shade.bias");
    EXPECT_EQ(idFrom(0.31, Kind::rayCast), "") << "of another place, as one from the light";
    EXPECT_EQ(idFrom(0.29, Kind::traceBegan), "");
}

}  // namespace
}  // namespace ticker::tasks
