#include "ClassOnDisk.h"

#include <grader/session/ClassView.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace ticker::session {
namespace {

using nlohmann::json;

const std::string kOddName = "J\xC3\xBCrgen, O'Neill_12";

std::string request(const std::string& name, int version, const std::string& ruling,
                    const std::string& who = "ann", const std::string& comment = "") {
    return json{{"submission", name},
                {"version", version},
                {"ruling", ruling},
                {"comment", comment},
                {"who", who}}
        .dump();
}

class Session : public testing::Test {
protected:
    tests::ClassOnDisk class_{{kOddName, "bob"}};
    ClassView view_{class_.out()};
};

TEST_F(Session, ListsTheClassWithFindingsAndDecisions) {
    EXPECT_EQ(view_.decide(request(kOddName, 0, "awarded", "ann", "fine")).status, 200);
    const json list = json::parse(view_.list().body).at("submissions");
    ASSERT_EQ(list.size(), 2U);
    EXPECT_EQ(list[0].at("name"), kOddName);
    EXPECT_EQ(list[0].at("findings"), json::array({"bump.inverted-u"}));
    EXPECT_EQ(list[0].at("decision").at("ruling"), "awarded");
    EXPECT_EQ(list[0].at("decision").at("who"), "ann");
    EXPECT_EQ(list[0].at("decision").at("comment"), "fine");
    EXPECT_EQ(list[0].at("decision").at("proposed"), "notAwarded")
        << "the overruled proposal stays beside the decision";
    EXPECT_FALSE(list[1].contains("decision"));
}

TEST_F(Session, KeepsTheFirstOfTwoWhoDecideAtOnceAndTellsTheSecond) {
    EXPECT_EQ(view_.decide(request("bob", 0, "awarded", "ann")).status, 200);
    const Reply late = view_.decide(request("bob", 0, "notYet", "cy"));
    EXPECT_EQ(late.status, 409);
    EXPECT_EQ(json::parse(late.body).at("who"), "ann");
    EXPECT_EQ(view_.decide(request("bob", 1, "notYet", "cy")).status, 200);
    EXPECT_EQ(json::parse(view_.submission("bob").body).at("history").size(), 2U);
}

TEST_F(Session, KeepsADecisionOnceThatIsSentAgainAfterALostAnswer) {
    const std::string sent = request("bob", 0, "awarded", "ann", "fine");
    EXPECT_EQ(view_.decide(sent).status, 200);
    const Reply again = view_.decide(sent);
    EXPECT_EQ(again.status, 200);
    EXPECT_EQ(json::parse(again.body).at("version"), 1);
    EXPECT_EQ(json::parse(view_.submission("bob").body).at("history").size(), 1U);
}

TEST_F(Session, IsTheSameAfterItWasStartedAgain) {
    EXPECT_EQ(view_.decide(request("bob", 0, "notYet")).status, 200);
    const ClassView again{class_.out()};
    EXPECT_EQ(again.list().body, view_.list().body);
}

TEST_F(Session, RefusesWhatIsNoDecision) {
    for (const std::string& body :
         {std::string{}, std::string{"[]"}, std::string{"{}"}, std::string{"\xFF\xFE"},
          request("bob", 0, "perhaps"), json{{"submission", "bob"}}.dump(),
          json{{"submission", "bob"},
               {"version", "0"},
               {"ruling", "awarded"},
               {"comment", ""},
               {"who", ""}}
              .dump(),
          request("bob", 0, "awarded", "ann", std::string(30'000, 'x'))})
        EXPECT_EQ(view_.decide(body).status, 400) << body.substr(0, 80);
    EXPECT_EQ(view_.decide(request("nobody", 0, "awarded")).status, 404);
    EXPECT_EQ(view_.decide(request("bob", 7, "awarded")).status, 409);
}

TEST_F(Session, GivesOutPicturesAndReportsOfTheClassAndNothingElse) {
    EXPECT_EQ(view_.image("bob", "bump-mapping.png").body, "png bytes");
    EXPECT_EQ(view_.reportPage("bob").body, "<!doctype html>the report");
    for (const char* file : {"../result.json", "none.png", "..png", "", "/etc/passwd", "a/b.png",
                             "../../bob/images/bump-mapping.png"})
        EXPECT_EQ(view_.image("bob", file).status, 404) << file;
    for (const char* name : {"..", "nobody", "", "bob/../bob", "."}) {
        EXPECT_EQ(view_.image(name, "bump-mapping.png").status, 404) << name;
        EXPECT_EQ(view_.submission(name).status, 404) << name;
        EXPECT_EQ(view_.reportPage(name).status, 404) << name;
    }
    std::filesystem::create_symlink("/etc/hostname", class_.out() / "bob/images/link.png");
    EXPECT_EQ(view_.image("bob", "link.png").status, 404);
}

TEST_F(Session, WaitsForASubmissionThatIsBeingGraded) {
    std::filesystem::remove(class_.out() / "bob" / "result.json");
    EXPECT_EQ(view_.submission("bob").status, 503);
    EXPECT_EQ(json::parse(view_.list().body).at("submissions").size(), 2U);
}

}  // namespace
}  // namespace ticker::session
