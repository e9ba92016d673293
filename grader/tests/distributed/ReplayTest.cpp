#include <grader/decision/distributed/ShadowReplay.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ticker::decision {
namespace {

/// A floor under a light, half a sphere's shadow: two of four rays arrive.
struct Case {
    ShadowQuestion question;
    ShadowLog log;

    Case() {
        raytracer::SceneDescription& scene = question.question.scene;
        scene.ambientLighting = raytracer::ColourRGB{0.1, 0.2, 0.3};
        scene.pointLights.emplace_back(Vector3{0.0, 4.0, 0.0}, raytracer::ColourRGB{0.5, 0.6, 0.7},
                                       64.0 * std::numbers::pi);
        raytracer::Material material;
        material.colour = raytracer::ColourRGB{0.9, 0.5, 0.2};
        scene.spheres.push_back({{0.3, 2.0, 0.0}, 0.3, material, nullptr});
        scene.planes.push_back({{}, {0.0, 1.0, 0.0}, material});
        question.zones = {{Zone::penumbra}};
        question.question.points = {{1, {}, {0.0, 1.0, 0.0}, {0.0, 3.0, 0.0}}};
    }

    /// Asks with rays to these x of the light's height and answers with this colour.
    void answer(const std::vector<double>& aims, const ColourRGB& colour) {
        probe::IlluminateAnswer given;
        given.state = probe::AnswerState::answered;
        given.colours = {colour};
        for (const double x : aims) {
            probe::Event event;
            event.kind = probe::Event::Kind::rayCast;
            event.a = {0.0, 1e-4, 0.0};
            event.b = Vector3{x, 4.0, 0.0} * 0.37;
            given.events.push_back(event);
        }
        log = readShadowLog(question, given);
    }
    [[nodiscard]] bool fitsAs(ShadowArithmetic arithmetic) const {
        return fits(log.points[0], log.scene(), log.settings(), {}, arithmetic);
    }
};

// By hand: the light's distance is 4, so that its colour arrives as it is (64 pi / (4 pi 16) = 1);
// N.L = 1 and R.V = 1.
const ColourRGB kAmbient{0.09, 0.1, 0.06};
const ColourRGB kDiffuse{0.9 * 0.5 * 0.8, 0.5 * 0.6 * 0.8, 0.2 * 0.7 * 0.8};
const ColourRGB kSpecular{0.25 * 1.2, 0.36 * 1.2, 0.49 * 1.2};

TEST(Replay, SeesWhichRaysAreBlockedWhateverTheirLength) {
    Case half;
    half.answer({-0.3, -0.2, 0.2, 0.3}, {});
    ASSERT_EQ(half.log.points[0].lines[0].size(), 4U);
    EXPECT_EQ(half.log.points[0].lines[0][0].toLight, Sight::open);
    EXPECT_EQ(half.log.points[0].lines[0][3].toLight, Sight::blocked);
    EXPECT_NEAR(half.log.points[0].lines[0][0].miss, 0.3 * 4.0 / std::hypot(0.3, 4.0), 1e-4);
}

TEST(Replay, FitsHalfOfTheLightAndNothingElse) {
    Case half;
    half.answer({-0.3, -0.2, 0.2, 0.3}, kAmbient + (kDiffuse + kSpecular) * 0.5);
    EXPECT_TRUE(half.fitsAs(ShadowArithmetic::right));
    EXPECT_FALSE(half.fitsAs(ShadowArithmetic::ambientScaled));
    EXPECT_FALSE(half.fitsAs(ShadowArithmetic::litIfAny));
    half.answer({-0.3, -0.2, 0.2, 0.3}, kAmbient + (kDiffuse + kSpecular) * 0.6);
    EXPECT_FALSE(half.fitsAs(ShadowArithmetic::right));
}

TEST(Replay, NamesEachMistakeOfArithmetic) {
    Case quarter;
    const std::vector<double> aims{-0.3, 0.2, 0.25, 0.3};
    quarter.answer(aims, (kAmbient + kDiffuse + kSpecular) * 0.25);
    EXPECT_TRUE(quarter.fitsAs(ShadowArithmetic::ambientScaled));
    quarter.answer(aims, kAmbient + kDiffuse * 0.25 + kSpecular);
    EXPECT_TRUE(quarter.fitsAs(ShadowArithmetic::specularUnshadowed));
    quarter.answer(aims, kAmbient + kDiffuse + kSpecular * 0.25);
    EXPECT_TRUE(quarter.fitsAs(ShadowArithmetic::diffuseUnshadowed));
    quarter.answer(aims, kAmbient + (kDiffuse + kSpecular) * 0.75);
    EXPECT_TRUE(quarter.fitsAs(ShadowArithmetic::inverted));
    quarter.answer(aims, kAmbient);
    EXPECT_TRUE(quarter.fitsAs(ShadowArithmetic::litIfAll));
    EXPECT_FALSE(quarter.fitsAs(ShadowArithmetic::right));
}

TEST(Replay, TurnsRaysRoundThatWereCastFromTheLight) {
    Case reversed;
    probe::IlluminateAnswer given;
    given.state = probe::AnswerState::answered;
    given.colours = {kAmbient};
    probe::Event event;
    event.kind = probe::Event::Kind::rayCast;
    event.a = {0.3, 4.0, 0.0};
    event.b = {-0.3, -4.0, 0.0};
    given.events = {event};
    reversed.log = readShadowLog(reversed.question, given);
    ASSERT_EQ(reversed.log.points[0].lines[0].size(), 1U);
    EXPECT_NEAR(reversed.log.points[0].lines[0][0].origin.magnitude(), 1e-4, 1e-9);
    EXPECT_EQ(reversed.log.points[0].lines[0][0].toLight, Sight::blocked);
}

}  // namespace
}  // namespace ticker::decision
