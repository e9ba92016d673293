#include "ClassOnDisk.h"

#include <grader/session/ClassView.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace ticker::session {
namespace {

using nlohmann::json;

const std::string kOddName = "J\xC3\xBCrgen, O'Neill_12";

std::string request(const std::string& name, int version, const std::string& ruling,
                    const std::string& who = "ann", const std::string& comment = "") {
    return json{{"decisions",
                 {{{"submission", name},
                   {"version", version},
                   {"ruling", ruling},
                   {"comment", comment},
                   {"who", who}}}}}
        .dump();
}

/// The one answer to a request with one decision.
json answerTo(const Reply& reply) {
    EXPECT_EQ(reply.status, 200) << reply.body;
    return json::parse(reply.body).at("answers").at(0);
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
    const json late = answerTo(view_.decide(request("bob", 0, "notYet", "cy")));
    EXPECT_EQ(late.at("isKept"), false);
    EXPECT_EQ(late.at("decision").at("who"), "ann");
    EXPECT_EQ(answerTo(view_.decide(request("bob", 1, "notYet", "cy"))).at("isKept"), true);
    EXPECT_EQ(json::parse(view_.submission("bob").body).at("history").size(), 2U);
}

TEST_F(Session, KeepsADecisionOnceThatIsSentAgainAfterALostAnswer) {
    const std::string sent = request("bob", 0, "awarded", "ann", "fine");
    EXPECT_EQ(view_.decide(sent).status, 200);
    const json again = answerTo(view_.decide(sent));
    EXPECT_EQ(again.at("isKept"), true);
    EXPECT_EQ(again.at("decision").at("version"), 1);
    EXPECT_EQ(json::parse(view_.submission("bob").body).at("history").size(), 1U);
}

TEST_F(Session, KeepsManyAtOnceAndSaysWhichWereOvertaken) {
    EXPECT_EQ(view_.decide(request("bob", 0, "awarded", "cy")).status, 200);
    json bulk = json::array();
    for (const std::string& name : {kOddName, std::string{"bob"}})
        bulk.push_back({{"submission", name},
                        {"version", 0},
                        {"ruling", "notYet"},
                        {"comment", ""},
                        {"who", "ann"},
                        {"bulk", "b1"}});
    const json answers =
        json::parse(view_.decide(json{{"decisions", bulk}}.dump()).body).at("answers");
    EXPECT_EQ(answers.at(0).at("isKept"), true);
    EXPECT_EQ(answers.at(0).at("decision").at("bulk"), "b1") << "what was decided in bulk says so";
    EXPECT_EQ(answers.at(1).at("isKept"), false);
    EXPECT_EQ(answers.at(1).at("decision").at("who"), "cy");
}

TEST_F(Session, KeepsCommentsOnLinesWithTheLinesThemselves) {
    json one = json::parse(request("bob", 0, "undecided")).at("decisions").at(0);
    one["notes"] = {{{"file", "BumpySphere.cpp"}, {"line", 1}, {"text", "why **int**?"}},
                    {{"file", "BumpySphere.cpp"}, {"line", 99}, {"text", "beyond the end"}},
                    {{"file", "../report.html"}, {"line", 1}, {"text", "no file of theirs"}},
                    {{"file", "BumpySphere.cpp"}, {"line", 1}, {"text", ""}},
                    {{"file", "BumpySphere.cpp"}, {"line", "1"}, {"text", "no number"}}};
    const json kept = answerTo(view_.decide(json{{"decisions", {one}}}.dump()));
    ASSERT_EQ(kept.at("decision").at("notes").size(), 1U) << kept;
    EXPECT_EQ(kept.at("decision").at("notes").at(0).at("code"), "int x; // <script>code</script>");
    EXPECT_EQ(store::Store{class_.out()}.decisions().at(0).notes.at(0).text, "why **int**?");
}

TEST_F(Session, KeepsCommentsOnLinesThatAreGoneAfterAnotherHandIn) {
    json one = json::parse(request("bob", 0, "undecided")).at("decisions").at(0);
    one["notes"] = {{{"file", "BumpySphere.cpp"}, {"line", 1}, {"text", "why int?"}}};
    const json first = answerTo(view_.decide(json{{"decisions", {one}}}.dump())).at("decision");
    std::filesystem::remove(class_.out() / "bob" / "code" / "BumpySphere.cpp");
    json two = json::parse(request("bob", 1, "notYet")).at("decisions").at(0);
    two["notes"] = first.at("notes");
    two["notes"].push_back({{"file", ".."}, {"line", 1}, {"code", "x"}, {"text", "no file"}});
    const json kept = answerTo(view_.decide(json{{"decisions", {two}}}.dump())).at("decision");
    EXPECT_EQ(kept.at("notes"), first.at("notes"));
}

// A decision may arrive after other files were handed in and graded.
TEST_F(Session, KeepsADecisionWithTheFilesThatTheTickerSaw) {
    EXPECT_EQ(json::parse(view_.submission("bob").body).at("files"), "");
    json one = json::parse(request("bob", 0, "awarded")).at("decisions").at(0);
    one["files"] = "aa";
    EXPECT_EQ(answerTo(view_.decide(json{{"decisions", {one}}}.dump())).at("decision").at("files"),
              "aa");
    one["files"] = std::string(1000, 'a');
    EXPECT_EQ(view_.decide(json{{"decisions", {one}}}.dump()).status, 400);
}

TEST_F(Session, SharesSavedCommentsAmongAllTickersOfTheClass) {
    const auto saved = [](const std::string& finding, const std::string& text) {
        return json{{"finding", finding}, {"text", text}, {"who", "ann"}}.dump();
    };
    EXPECT_EQ(view_.saveComment(saved("bump.inverted-u", "Turn one sign.")).status, 200);
    EXPECT_EQ(view_.saveComment(saved("bump.inverted-u", "Turn one sign.")).status, 200);
    EXPECT_EQ(view_.saveComment(saved("", "Well done, {name}.")).status, 200);
    EXPECT_EQ(view_.saveComment(saved("", "")).status, 400);
    ClassView other{class_.out()};
    const json comments = json::parse(other.list().body).at("comments");
    ASSERT_EQ(comments.size(), 2U) << "each once";
    EXPECT_EQ(comments.at(0).at("text"), "Turn one sign.");
    EXPECT_EQ(comments.at(0).at("who"), "ann");
    EXPECT_EQ(other.dropComment(json{{"id", comments.at(0).at("id")}}.dump()).status, 200);
    EXPECT_EQ(json::parse(view_.list().body).at("comments").size(), 1U);
    EXPECT_EQ(view_.dropComment("{}").status, 400);
}

TEST_F(Session, TellsThatNothingHasChangedToWhoKnowsTheState) {
    const std::string state = json::parse(view_.list().body).at("state");
    EXPECT_EQ(json::parse(view_.list(state).body), (json{{"state", state}}));
    EXPECT_EQ(view_.decide(request("bob", 0, "awarded")).status, 200);
    EXPECT_EQ(json::parse(view_.list(state).body).at("submissions").size(), 2U);
}

TEST_F(Session, ShowsACommentAsTheStudentWillSeeIt) {
    const Reply shown = view_.preview(json{{"text", "a **b** <script>c</script>"}}.dump());
    EXPECT_EQ(json::parse(shown.body).at("html"),
              "<p>a <strong>b</strong> &lt;script&gt;c&lt;/script&gt;</p>\n");
    EXPECT_EQ(view_.preview("[]").status, 400);
}

TEST_F(Session, IsTheSameAfterItWasStartedAgain) {
    EXPECT_EQ(view_.decide(request("bob", 0, "notYet")).status, 200);
    const ClassView again{class_.out()};
    EXPECT_EQ(again.list().body, view_.list().body);
}

TEST_F(Session, RefusesWhatIsNoDecision) {
    for (const std::string& body :
         {std::string{}, std::string{"[]"}, std::string{"{}"}, std::string{"\xFF\xFE"},
          request("bob", 0, "perhaps"), json{{"decisions", {{{"submission", "bob"}}}}}.dump(),
          json{{"decisions", {1}}}.dump(), json{{"decisions", "bob"}}.dump(),
          json{{"decisions",
                {{{"submission", "bob"},
                  {"version", "0"},
                  {"ruling", "awarded"},
                  {"comment", ""},
                  {"who", ""}}}}}
              .dump(),
          request("bob", 0, "awarded", "ann", std::string(30'000, 'x'))})
        EXPECT_EQ(view_.decide(body).status, 400) << body.substr(0, 80);
    EXPECT_EQ(view_.decide(request("nobody", 0, "awarded")).status, 404);
    EXPECT_EQ(answerTo(view_.decide(request("bob", 7, "awarded"))).at("isKept"), false);
}

TEST_F(Session, SaysWhyADecisionIsTooLong) {
    json one = json::parse(request("bob", 0, "awarded", "ann", std::string(15'000, 'x')))
                   .at("decisions")
                   .at(0);
    one["notes"] = {{{"file", "BumpySphere.cpp"}, {"line", 1}, {"text", std::string(6'000, 'x')}}};
    const Reply reply = view_.decide(json{{"decisions", {one}}}.dump());
    EXPECT_EQ(reply.status, 400);
    EXPECT_EQ(json::parse(reply.body).at("error"),
              "The comment and the comments on lines have 21000 bytes together, and 20000 are the "
              "most; shorten them.");
}

TEST_F(Session, KeepsDecisionsOfWhoHasTheLongestNameThatThePageAllows) {
    std::string name;
    for (int i = 0; i < 60; ++i)
        name += "\xE5\xBC\xA0";
    EXPECT_EQ(view_.decide(request("bob", 0, "awarded", name)).status, 200);
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

TEST_F(Session, LeavesOutASubmissionWhoseFolderWasRemoved) {
    std::filesystem::remove_all(class_.out() / "bob");
    const json list = json::parse(view_.list().body).at("submissions");
    ASSERT_EQ(list.size(), 1U);
    EXPECT_EQ(list.at(0).at("name"), kOddName);
    EXPECT_EQ(view_.size(), 1U);
    EXPECT_EQ(view_.submission("bob").status, 404) << "a page that still lists it must not wait";
    EXPECT_EQ(view_.pictures("bob").status, 404);
}

TEST_F(Session, SaysWhyASubmissionCannotBeShownAndStoresADecisionAboutItAllTheSame) {
    const auto broken = [&](const std::string& text) {
        std::ofstream{class_.out() / "bob" / "result.json"} << text;
        EXPECT_EQ(view_.pictures("bob").status, 404) << text;
        const Reply reply = view_.submission("bob");
        EXPECT_EQ(reply.status, 404) << text;
        return json::parse(reply.body).at("error").get<std::string>();
    };
    EXPECT_EQ(broken("{").find("It is damaged: result.json"), 0U);
    const std::string other = resultJson(tests::markedResult("cy", Verdict::awarded));
    EXPECT_EQ(broken(other).find("Its result.json is that of \"cy\"."), 0U);
    EXPECT_EQ(view_.decide(request("bob", 0, "awarded")).status, 200);
}

TEST_F(Session, SaysThatTheExerciseOfASubmissionIsUnknown) {
    SubmissionResult result = tests::markedResult("bob", Verdict::awarded);
    result.exercise = "tick9";
    std::ofstream{class_.out() / "bob" / "result.json"} << resultJson(result);
    const Reply reply = view_.submission("bob");
    EXPECT_EQ(reply.status, 404);
    EXPECT_NE(reply.body.find("tick9"), std::string::npos) << reply.body;
}

}  // namespace
}  // namespace ticker::session
