#include <grader/tasks/bump/words/DirectionWords.h>
#include <grader/tasks/bump/words/GrowthWords.h>
#include <grader/tasks/bump/words/ParametrisationWords.h>
#include <grader/tasks/bump/words/WrongWords.h>

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace ticker::tasks::bump {
namespace {

bool says(const Response& response, const std::string& part) {
    return directionWords(response).message.find(part) != std::string::npos;
}

TEST(DirectionWords, SayByHowMuchEverythingIsOff) {
    Response response;
    response.u.bandDirection.fill(-38.0);
    response.u.bandDirection[3] = -42.0;
    EXPECT_TRUE(says(response, "everywhere 40 degrees off"));
    response.u.bandDirection[3] = -47.0;
    EXPECT_TRUE(says(response, "everywhere")) << "nine degrees apart";
    response.u.bandDirection[3] = -49.0;
    EXPECT_FALSE(says(response, "everywhere")) << "eleven";
    response.u.bandDirection.fill(11.0);
    EXPECT_TRUE(says(response, "everywhere 11 degrees off"));
    response.u.bandDirection.fill(9.0);
    EXPECT_FALSE(says(response, "everywhere"));
}

TEST(DirectionWords, SayInWhichRowsASignIsWrong) {
    Response response;
    response.v.bandDirection = {5.0, -29.0, 151.0, -179.0, 180.0, 29.0, 0.0, 0.0};
    EXPECT_TRUE(says(response, "inverted from 25 % to 62 %"));
    EXPECT_NE(directionWords(response).hint.find("A sign changes"), std::string::npos);
    EXPECT_NE(directionWords(response).hint.find("a.z * b.x - a.x * b.z"), std::string::npos);
    EXPECT_NE(directionWords(response).hint.find("An angle in degrees"), std::string::npos);
    response.v.bandDirection[6] = 31.0;
    EXPECT_FALSE(says(response, "inverted from")) << "neither right nor inverted";
    response.v.bandDirection[6] = 149.0;
    EXPECT_FALSE(says(response, "inverted from"));
    response.v.bandDirection.fill(180.0);
    EXPECT_FALSE(says(response, "inverted from")) << "everywhere";
    response.v.bandDirection[0] = 0.0;
    EXPECT_TRUE(says(response, "inverted from 12 % to 100 %"));
    response.v.bandDirection.fill(180.0);
    response.v.bandDirection[7] = 0.0;
    EXPECT_TRUE(says(response, "inverted from 0 % to 88 %"));
    response.v.bandDirection.fill(0.0);
    EXPECT_FALSE(says(response, "inverted from"));
    EXPECT_EQ(directionWords(response).hint.find("A sign changes"), std::string::npos);
}

TEST(DirectionWords, SayThatOneDifferenceContainsTheOtherOne) {
    Response response;
    response.u.bandDirection.fill(45.0);
    response.u.bandDirection[3] = 49.9;
    EXPECT_TRUE(says(response, "Bv contains the difference along u"));
    EXPECT_NE(directionWords(response).hint.find("the point's own column"), std::string::npos);
    response.u.bandDirection.fill(-45.0);
    EXPECT_TRUE(says(response, "Bv contains")) << "the texel on the left";
    response.v.bandDirection[2] = 5.1;
    EXPECT_FALSE(says(response, "contains")) << "v is not right";
    std::swap(response.u, response.v);
    response.u.bandDirection[2] = 0.0;
    EXPECT_TRUE(says(response, "Bu contains the difference along v"));
    EXPECT_NE(directionWords(response).hint.find("the point's own row"), std::string::npos);
    response.v.bandDirection[6] = -39.9;
    EXPECT_FALSE(says(response, "contains"));
    response.u.bandDirection.fill(45.0);
    response.v.bandDirection.fill(45.0);
    EXPECT_FALSE(says(response, "contains")) << "both are turned";
}

TEST(DirectionWords, SayThatOneDifferenceContainsAPartOfTheOtherOne) {
    Response response;
    response.u.shares.right = response.v.shares.right = 1.0;
    response.u.bandDirection.fill(14.0);
    EXPECT_TRUE(says(response, "along v, too, by 25 % of what it tilts along u"));
    EXPECT_NE(directionWords(response).hint.find("all texels of a column"), std::string::npos);
    std::swap(response.u, response.v);
    EXPECT_TRUE(says(response, "Bu contains a part of the difference along v"));
    EXPECT_NE(directionWords(response).hint.find("all texels of a row"), std::string::npos);
    response.v.bandDirection[3] = -14.0;
    EXPECT_FALSE(says(response, "contains")) << "one way in the north, the other in the south";
}

/// The hints of code that is right on these spheres alone.
Hints rightOn(bool square, bool unitSphere, bool aside) {
    const auto kindOf = [](bool isRight) {
        return isRight ? RampKind::right : RampKind::strangeDirection;
    };
    Hints hints;
    hints.square.kind = kindOf(square);
    hints.unitSphere.kind = kindOf(unitSphere);
    hints.asideSphere.kind = kindOf(aside);
    return hints;
}

TEST(DirectionWords, SayThatTheCentreIsMissingWhereASphereAtTheOriginIsRight) {
    const auto hintWith = [](const Hints& hints) { return directionWords({}, hints).hint; };
    EXPECT_EQ(hintWith(rightOn(false, true, false)).rfind("On a sphere of radius 1", 0), 0U);
    const std::string plain = directionWords({}).hint;
    EXPECT_EQ(hintWith(rightOn(false, false, false)), plain);
    EXPECT_EQ(hintWith(rightOn(true, true, false)), plain);
    EXPECT_EQ(hintWith(rightOn(false, true, true)), plain);
}

TEST(LandingWords, AskTheSphereAsideBeforeTheSize) {
    Examination examination;
    examination.ladder.ramps.kind = RampKind::strangeParametrisation;
    const auto says = [&](const Hints& hints, const char* part) {
        return landingWords(examination, hints).message.find(part) != std::string::npos;
    };
    EXPECT_TRUE(says(rightOn(true, true, false), "far to the side and below"));
    EXPECT_TRUE(says(rightOn(true, true, true), "On square maps"));
    for (const WrongReason reason : {WrongReason::patchy, WrongReason::strangeDirection}) {
        examination.ladder.ramps.response = Response{};
        const std::string message =
            wrongWords(reason, examination, rightOn(true, true, false)).message;
        EXPECT_NE(message.find("far to the side and below"), std::string::npos) << message;
    }
}

TEST(GrowthWords, SayThatAReversedTiltIsPastTheHorizon) {
    Examination examination;
    examination.ladder.growsWithSlope = true;
    examination.proportion.growth = -8.6;
    const auto message = [&] { return growthWords(examination).message; };
    EXPECT_NE(message().find("only -8.6 times"), std::string::npos) << message();
    examination.proportion.pastHorizon = 0.6;
    EXPECT_NE(message().find("leans 90 degrees or more, at 60 %"), std::string::npos) << message();
    examination.proportion.growth = 8.6;
    EXPECT_NE(message().find("only 8.6 times"), std::string::npos) << message();
}

TEST(LandingWords, NameWhatTakesTheSignOffADifference) {
    Examination examination;
    examination.ladder.ramps.kind = RampKind::signLost;
    const std::string hint = landingWords(examination, {}).hint;
    for (const char* cause : {"an abs", "a square", "a max", "unsigned type"})
        EXPECT_NE(hint.find(cause), std::string::npos) << cause;
}

TEST(DirectionWords, SayThatATangentTurnsWithTheRow) {
    Response response;
    response.v.bandDirection = {49.0, 44.0, 33.0, 13.0, -12.0, -33.0, -44.0, -49.0};
    EXPECT_TRUE(says(response, "from 49 degrees aside at the map's top to -49 at its bottom"));
    EXPECT_EQ(directionWords(response).hint.rfind("Pv turns away with latitude", 0), 0U);
    response.v.bandDirection[4] = 150.0;
    EXPECT_FALSE(says(response, "turning with the row")) << "a leap, not a turn";
    response.v.bandDirection = {20.0, 15.0, 9.0, 3.0, -3.0, -9.0, -15.0, -19.0};
    EXPECT_FALSE(says(response, "turning with the row")) << "less than 40 degrees in all";
}

TEST(DirectionWords, SayWhichHalfStaysSmooth) {
    Response response;
    response.u.shares.dead = 0.5;
    response.u.deadFrom = {-0.9, -1.0, -0.9};
    response.u.deadTo = {0.9, -0.01, 0.9};
    EXPECT_NE(patchyWords(response).message.find("all of them below the equator"),
              std::string::npos);
    response.u.deadTo.y = 0.3;
    EXPECT_EQ(patchyWords(response).message.find("all of them"), std::string::npos);
    response.u.deadFrom.x = 0.0;
    EXPECT_NE(patchyWords(response).message.find("on the right half"), std::string::npos);
}

TEST(DirectionWords, LookAtTheWorstPointOfTheWorseAxis) {
    Response response;
    response.u.worstDirection = -90.0;
    response.v.worstDirection = 60.0;
    response.u.worst = {0.0, 1.0, 0.0};
    response.v.worst = {0.0, -1.0, 0.0};
    const std::string onU = directionWords(response).hint;
    response.v.worstDirection = 120.0;
    EXPECT_NE(directionWords(response).hint, onU);
    response.u.shares.dead = 0.3;
    response.v.shares.dead = 0.2;
    response.u.deadAt = {0.0, 1.0, 0.0};
    response.v.deadAt = {0.0, -1.0, 0.0};
    const std::string patchyU = patchyWords(response).hint;
    response.v.shares.dead = 0.4;
    EXPECT_NE(patchyWords(response).hint, patchyU);
}

}  // namespace
}  // namespace ticker::tasks::bump
