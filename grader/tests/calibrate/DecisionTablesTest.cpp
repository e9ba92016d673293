#include <grader/lab/calibrate/BlockRecord.h>
#include <grader/lab/calibrate/campaigns/DecisionTables.h>
#include <grader/tasks/shadows/ShadowFindings.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ticker::calibrate {
namespace {

Subject mistake(const std::string& finding) {
    Subject subject;
    subject.name = "T2.1/some-mistake";
    subject.task = "T2.1";
    subject.file = "Renderer.cpp";
    subject.expect.states = {"failed"};
    subject.expect.findings = {finding};
    return subject;
}

/// The tables of 100 decisions.
Summary tables(const Subject& subject, std::size_t missed, std::size_t named) {
    BlockRecord block;
    block.subject = subject.name;
    block.task = subject.task;
    block.decisions = 100;
    block.wrongState = missed;
    block.wrongName = named;
    block.cpu = {{20, 100}};
    return tablesOf({subject}, {block.json()});
}

TEST(DecisionTables, ExpectThatNoMistakeIsMissed) {
    const Subject exact = mistake(std::string{tasks::kShadowWrong.id});
    EXPECT_TRUE(tables(exact, 0, 2).asExpected);
    EXPECT_FALSE(tables(exact, 1, 0).asExpected);
    EXPECT_FALSE(tables(exact, 0, 3).asExpected) << "too many have another name";
}

TEST(DecisionTables, CountDataRacesApartAndExpectThatNoneIsMissed) {
    const Subject race = mistake(std::string{tasks::kShadowThreadsMixed.id});
    EXPECT_TRUE(tables(race, 0, 0).asExpected);
    EXPECT_FALSE(tables(race, 1, 0).asExpected);
    const std::string text = tables(race, 1, 0).text;
    EXPECT_NE(text.find("| data races that passed | 100 | 1 |"), std::string::npos);
    EXPECT_NE(text.find("| exact mistakes that passed | 0 | 0 |"), std::string::npos);
}

TEST(DecisionTables, ListOnlyThoseWithAnUnexpectedResult) {
    const Subject exact = mistake(std::string{tasks::kShadowWrong.id});
    const std::string right = tables(exact, 0, 0).text;
    EXPECT_EQ(right.find("T2.1/some-mistake"), std::string::npos);
    EXPECT_NE(right.find("\n1 mistakes had the expected result in every decision"),
              std::string::npos);
    const std::string wrong = tables(exact, 1, 0).text;
    EXPECT_NE(wrong.find("| T2.1/some-mistake | 100 | 1 |"), std::string::npos);
    EXPECT_NE(wrong.find("\n0 mistakes had"), std::string::npos);
}

}  // namespace
}  // namespace ticker::calibrate
