#include <grader/decision/bump/DirectionWords.h>

#include <gtest/gtest.h>

#include <string>

namespace ticker::decision::bump {
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
}  // namespace ticker::decision::bump
