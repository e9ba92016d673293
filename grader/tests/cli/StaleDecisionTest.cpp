// Exports where a decision is about files that the student has handed in again since.
#include <grader/store/Store.h>
#include <grader/tests/support/Files.h>
#include <grader/tests/support/TemporaryFolder.h>

#include "RunTicker.h"

#include <gtest/gtest.h>

#include <string>

namespace ticker::cli {
namespace {

const std::string kHandedIn = "grader/corpus/samples/notAwarded/template-untouched/BumpySphere.cpp";

/// Decisions about an earlier hand-in of Ann, this hand-in of Bo, and unknown files of Cy.
class StaleDecision : public testing::Test {
protected:
    StaleDecision() {
        for (const std::string name : {"ann_1", "bo_2", "cy_3"})
            folder_.write("class/" + name + "/BumpySphere.cpp", tests::readFile(kHandedIn));
        folder_.write("gradebook.csv",
                      "Student,ID,SIS User ID,SIS Login ID,Section,Tick 1* (815)\n"
                      "    Points Possible,,,,,10\n"
                      "Ann,1,,a1,CS,\nBo,2,,b2,CS,\nCy,3,,c3,CS,\n");
        EXPECT_EQ(run("grade " + at("class") + " -o " + at("out") + " --seed 7").status, 0);
        store::Store store{folder_.path() / "out"};
        for (const store::ResultRow& row : store.results()) {
            Decision decision;
            decision.submission = row.submission;
            decision.ruling = Ruling::awarded;
            if (row.submission == "ann_1") decision.files = "digest of other files";
            if (row.submission == "bo_2") decision.files = row.inputs.files;
            static_cast<void>(store.decide(decision));
        }
    }

    Ran run(const std::string& arguments) {
        return runTicker(arguments, (folder_.path() / "errors").string());
    }
    Ran canvas(const std::string& more = {}) {
        return run("report " + at("out") + " --format canvas --worksheet " + at("gradebook.csv") +
                   more);
    }
    [[nodiscard]] std::string at(const std::string& path) const {
        return "'" + (folder_.path() / path).string() + "'";
    }

    tests::TemporaryFolder folder_;
};

const std::string kWarning =
    "ticker: 1 decision is about an earlier hand-in (ann_1); look at it in a session (Show: "
    "changed since decided) before you upload";

TEST_F(StaleDecision, IsNamedByAnExport) {
    const Ran ran = canvas();
    ASSERT_EQ(ran.status, 0) << ran.errors;
    EXPECT_NE(ran.errors.find("3 graded"), std::string::npos) << ran.errors;
    EXPECT_NE(ran.errors.find(kWarning + "\n"), std::string::npos) << ran.errors;
}

TEST_F(StaleDecision, IsLeftOutWhereOnlyDecidedOnesAreWanted) {
    const Ran ran = canvas(" --decided-only");
    ASSERT_EQ(ran.status, 0) << ran.errors;
    EXPECT_NE(ran.errors.find("2 graded"), std::string::npos) << ran.errors;
    EXPECT_NE(ran.errors.find(kWarning + "; --decided-only leaves their marks out\n"),
              std::string::npos)
        << ran.errors;
}

TEST_F(StaleDecision, IsNamedWhenTheNewHandInIsGraded) {
    const Ran ran = run("grade " + at("class") + " -o " + at("out") + " --resume");
    ASSERT_EQ(ran.status, 0) << ran.errors;
    EXPECT_NE(ran.errors.find(kWarning), std::string::npos) << ran.errors;
}

TEST_F(StaleDecision, OfNobodyIsNotMentioned) {
    const Ran ran = run("report " + at("out") + " --format gradescope --submission bo_2");
    ASSERT_EQ(ran.status, 0) << ran.errors;
    EXPECT_EQ(ran.errors, "");
}

}  // namespace
}  // namespace ticker::cli
