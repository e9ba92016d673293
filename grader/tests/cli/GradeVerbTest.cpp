#include <grader/store/Store.h>
#include <grader/tests/support/FitsSchema.h>
#include <grader/tests/support/TemporaryFolder.h>

#include "RunTicker.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

class Verbs : public testing::Test {
protected:
    Ran run(const std::string& arguments) {
        return runTicker(arguments, (folder_.path() / "errors").string());
    }

    [[nodiscard]] static std::string repository(const std::string& path) {
        return "'" + (fs::path{TICKER_SOURCE_DIR} / path).string() + "'";
    }

    [[nodiscard]] fs::path at(const std::string& path) const { return folder_.path() / path; }

    [[nodiscard]] static std::string readBytes(const fs::path& file) {
        std::ifstream stream{file, std::ios::binary};
        return {std::istreambuf_iterator<char>{stream}, {}};
    }

    tests::TemporaryFolder folder_;
};

TEST_F(Verbs, GradeWritesEverythingThatTheContractNames) {
    const std::string out = at("out").string();
    const Ran ran = run("grade " + repository("grader/corpus/samples/notAwarded/bump-inverted-u") +
                        " -o '" + out + "' --seed 7");
    EXPECT_EQ(ran.status, 0) << ran.errors;
    EXPECT_NE(ran.output.find("bump.inverted-u"), std::string::npos) << ran.output;
    EXPECT_EQ(ran.errors.find("1 submission:"), 0U) << ran.errors;
    for (const char* file :
         {"index.html", "summary.csv", "bump-inverted-u/result.json", "bump-inverted-u/report.html",
          "bump-inverted-u/student.html", "bump-inverted-u/images"})
        EXPECT_TRUE(fs::exists(fs::path{out} / file)) << file;
}

TEST_F(Verbs, ExplainSaysWhatIsMissingInAnEmptyFolder) {
    fs::create_directory(at("empty"));
    const Ran ran = run("explain '" + at("empty").string() + "'");
    EXPECT_EQ(ran.status, 0) << ran.errors;
    const std::string reason = "There is neither BumpySphere.cpp nor Renderer.cpp.";
    const std::size_t first = ran.output.find(reason);
    EXPECT_NE(first, std::string::npos) << ran.output;
    EXPECT_EQ(ran.output.find(reason, first + 1), std::string::npos) << ran.output;
}

TEST_F(Verbs, ReportWritesTheSamePagesAgainFromTheResultAlone) {
    const fs::path out = at("out");
    ASSERT_EQ(run("grade " + repository("grader/corpus/samples/notAwarded/distributed-off-centre") +
                  " -o '" + out.string() + "'")
                  .status,
              0);
    std::map<fs::path, std::string> pages;
    for (const char* name : {"index.html", "distributed-off-centre/report.html",
                             "distributed-off-centre/student.html"}) {
        pages[out / name] = readBytes(out / name);
        fs::remove(out / name);
    }
    const Ran ran = run("report '" + out.string() + "' --format html --quiet");
    EXPECT_EQ(ran.status, 0) << ran.errors;
    for (const auto& [file, text] : pages) {
        EXPECT_TRUE(readBytes(file) == text) << file;
        EXPECT_NE(ran.output.find(file.string()), std::string::npos) << ran.output;
    }
    EXPECT_EQ(run("report '" + out.string() + "' --format html --submission nobody").status, 2);
}

TEST_F(Verbs, GradeSaysOnceThatThereIsATextAndNoFile) {
    fs::create_directories(at("class/ann"));
    std::ofstream{at("class/ann/notes.txt")} << "I could not finish.";
    const Ran ran =
        run("grade '" + at("class/ann").string() + "' --single -o '" + at("out").string() + "'");
    ASSERT_EQ(ran.status, 0) << ran.errors;
    const std::size_t first = ran.output.find("intake.missing-file");
    ASSERT_NE(first, std::string::npos) << ran.output;
    EXPECT_EQ(ran.output.find("intake.missing-file", first + 1), std::string::npos) << ran.output;
    const auto result = nlohmann::json::parse(readBytes(at("out/ann/result.json")));
    EXPECT_EQ(result.at("option"), "none");
}

TEST_F(Verbs, GradeTakesARubricWhoseOptionsHaveNamesOfTheirOwn) {
    std::ofstream{at("rubric.json")} << R"({"maxScore": 1, "screenshotTask": "screenshot",
        "options": [{"name": "bumps", "tasks": ["T1"], "points": 1}], "severities": {}})";
    const fs::path out = at("out");
    const Ran ran = run("grade " + repository("grader/corpus/samples/notAwarded/bump-inverted-u") +
                        " -o '" + out.string() + "' --rubric '" + at("rubric.json").string() + "'");
    ASSERT_EQ(ran.status, 0) << ran.errors;
    const std::string result = readBytes(out / "bump-inverted-u/result.json");
    EXPECT_TRUE(tests::fitsSchema(result, "result")) << result;
    EXPECT_NE(result.find("\"option\": \"bumps\""), std::string::npos) << result;
    const std::string page = readBytes(out / "bump-inverted-u/student.html");
    EXPECT_NE(page.find("It takes T1."), std::string::npos);
    const std::string seed = nlohmann::json::parse(result).at("seed").get<std::string>();
    EXPECT_EQ(page.find(seed), std::string::npos);
    EXPECT_NE(readBytes(out / "bump-inverted-u/report.html").find(seed), std::string::npos)
        << "that one is for staff";
}

TEST_F(Verbs, GradeGivesTheSameResultForTheSameSeedButForTiming) {
    const auto resultOf = [&](const std::string& out) {
        const Ran ran =
            run("grade " + repository("grader/corpus/samples/awarded/reference-distributed") +
                " -o '" + at(out).string() + "' --seed 11");
        EXPECT_EQ(ran.status, 0) << ran.errors;
        auto result =
            nlohmann::json::parse(readBytes(at(out) / "reference-distributed" / "result.json"));
        result.erase("timing");
        return result;
    };
    EXPECT_EQ(resultOf("first"), resultOf("second"));
}

TEST_F(Verbs, CheckSaysThatNothingIsAttemptedInTheTemplate) {
    const Ran ran = run("check " + repository("student_template/exercise"));
    EXPECT_EQ(ran.status, 0) << ran.errors;
    EXPECT_NE(ran.output.find("T1 Bump mapping: not attempted"), std::string::npos) << ran.output;
    EXPECT_NE(ran.output.find(": not awarded"), std::string::npos) << ran.output;
}

TEST_F(Verbs, AnExerciseAndItsOptionsAreKnownByName) {
    const std::string sample = repository("grader/corpus/samples/notAwarded/bump-inverted");
    EXPECT_EQ(run("check " + sample + " --exercise tick1star").status, 1);
    const Ran unknown = run("check " + sample + " --exercise tick9");
    EXPECT_EQ(unknown.status, 2);
    EXPECT_NE(unknown.errors.find("tick1star"), std::string::npos) << unknown.errors;
    const Ran option = run("check " + sample + " --option T9");
    EXPECT_EQ(option.status, 2);
    EXPECT_NE(option.errors.find("--option T9: tick1star has no such option; expected T1, T2 or "
                                 "auto"),
              std::string::npos)
        << option.errors;
}

TEST_F(Verbs, ResultsOfAnotherExerciseAreNotMixedIn) {
    const std::string sample = repository("grader/corpus/samples/awarded/reference-bump");
    const std::string out = at("out").string();
    ASSERT_EQ(run("grade " + sample + " -o '" + out + "'").status, 0);
    EXPECT_EQ(nlohmann::json::parse(readBytes(at("out") / "reference-bump" / "result.json"))
                  .at("exercise"),
              "tick1star");
    store::Store{at("out")}.remember("exercise", "tick9");
    const Ran ran = run("grade " + sample + " -o '" + out + "'");
    EXPECT_EQ(ran.status, 2);
    EXPECT_NE(ran.errors.find("holds results of tick9; give results of tick1star another folder"),
              std::string::npos)
        << ran.errors;
}

TEST_F(Verbs, CheckExitsWithOneWhereATaskFails) {
    const Ran ran = run("check " + repository("grader/corpus/samples/notAwarded/bump-inverted"));
    EXPECT_EQ(ran.status, 1) << ran.errors;
    EXPECT_NE(ran.output.find("bump.inverted"), std::string::npos) << ran.output;
}

TEST_F(Verbs, RenderRepeatsUnderASeedWhateverTheThreads) {
    const std::string scene = "render " + repository("scenes/distributed.xml") + " -r 32x24 -o '";
    EXPECT_EQ(run(scene + at("a.png").string() + "' --seed 1 --threads 1").status, 0);
    EXPECT_EQ(run(scene + at("b.png").string() + "' --seed 1 --threads 2").status, 0);
    EXPECT_EQ(run(scene + at("c.png").string() + "' --seed 2 --threads 2").status, 0);
    EXPECT_FALSE(readBytes(at("a.png")).empty());
    EXPECT_EQ(readBytes(at("a.png")), readBytes(at("b.png")));
    EXPECT_NE(readBytes(at("a.png")), readBytes(at("c.png")));
}

TEST_F(Verbs, RenderTakesASubmissionOrTheOracle) {
    const std::string scene = "render " + repository("scenes/bump-mapping.xml") + " -r 32x24 -o '";
    const Ran submission = run(scene + at("a.png").string() + "' --seed 1 --solution " +
                               repository("grader/corpus/samples/awarded/reference-bump"));
    EXPECT_EQ(submission.status, 0) << submission.errors;
    const Ran oracle = run(scene + at("b.png").string() + "' --engine oracle");
    EXPECT_EQ(oracle.status, 0) << oracle.errors;
    EXPECT_TRUE(fs::exists(at("a.png")) && fs::exists(at("b.png")));
}

TEST_F(Verbs, WrongUsageAndUnreadableInputExitWithTwoAndOneLine) {
    for (const std::string& arguments :
         {std::string{"frobnicate"}, std::string{"grade"},
          "grade /no/such/place -o " + at("x").string(),
          "render /no/scene.xml -o " + at("x.png").string(), "report " + folder_.path().string(),
          repository("scenes") + " --seed x"}) {
        const Ran ran = run(arguments);
        EXPECT_EQ(ran.status, 2) << arguments << ": " << ran.errors;
        EXPECT_EQ(std::count(ran.errors.begin(), ran.errors.end(), '\n'), 1)
            << arguments << ": " << ran.errors;
        EXPECT_EQ(ran.output, "") << arguments;
    }
}

TEST_F(Verbs, ReportReadsBackWhatGradeWrote) {
    const std::string out = at("out").string();
    ASSERT_EQ(run("grade " + repository("grader/corpus/samples/notAwarded/template-untouched") +
                  " -o '" + out + "' --seed 7")
                  .status,
              0);
    const Ran csv = run("report '" + out + "' --format csv");
    EXPECT_EQ(csv.output, readBytes(fs::path{out} / "summary.csv"));
    const Ran json = run("report '" + out + "' --format json");
    EXPECT_EQ(nlohmann::json::parse(json.output).size(), 1U);
}

class ClassOfStubs : public Verbs {
protected:
    ClassOfStubs() {
        for (const char* name : {"ann", "bob", "cyd"}) {
            fs::create_directories(at("class"));
            fs::copy(
                fs::path{TICKER_SOURCE_DIR} / "grader/corpus/samples/notAwarded/template-untouched",
                at("class") / name);
        }
    }
    Ran grade(const std::string& more) {
        return run("grade '" + at("class").string() + "' -o '" + at("out").string() +
                   "' --seed 7 " + more);
    }
    [[nodiscard]] bool isGraded(const std::string& name) const {
        return fs::exists(at("out") / name / "result.json");
    }
};

TEST_F(ClassOfStubs, AShareIsEveryNthSubmissionAlone) {
    const Ran ran = grade("--share 1/2 --results-only");
    EXPECT_EQ(ran.status, 0) << ran.errors;
    EXPECT_TRUE(isGraded("ann") && isGraded("cyd"));
    EXPECT_FALSE(isGraded("bob"));
    EXPECT_EQ(grade("--share 4/4 --results-only").status, 0) << "nothing left is no error";
    EXPECT_FALSE(isGraded("bob"));
    for (const char* wrong : {"0/2", "3/2", "2", "1/2x", "a/b"})
        EXPECT_EQ(grade(std::string{"--share "} + wrong).status, 2) << wrong;
}

TEST_F(ClassOfStubs, SingleTakesAllOfAPathForOneSubmission) {
    const Ran ran = grade("--single --format gradescope,junit");
    EXPECT_EQ(ran.status, 0) << ran.errors;
    EXPECT_TRUE(isGraded("class"));
    EXPECT_FALSE(isGraded("ann"));
    EXPECT_TRUE(fs::exists(at("out/class/gradescope.json")));
    EXPECT_TRUE(fs::exists(at("out/class/junit.xml")));
}

TEST_F(ClassOfStubs, ReportWritesTheFileOfEachSubmissionAndNamesIt) {
    ASSERT_EQ(grade("").status, 0);
    const std::string out = at("out").string();
    const Ran one = run("report '" + out + "' --format autolab --submission bob");
    EXPECT_EQ(one.output, out + "/bob/autolab.txt\n") << one.errors;
    const Ran all = run("report '" + out + "' --format prairielearn");
    EXPECT_EQ(std::count(all.output.begin(), all.output.end(), '\n'), 3) << all.output;
    EXPECT_EQ(run("report '" + out + "' --format moodle").status, 2) << "needs a worksheet";
    EXPECT_EQ(run("report '" + out + "' --format tarot").status, 2);
}

// A platform would take them for the newest result.
TEST_F(ClassOfStubs, LeavesNoFileOfAPlatformBesideAResultThatItIsNotMadeFrom) {
    ASSERT_EQ(grade("--format gradescope,prairielearn,classroom,github,autolab,junit").status, 0);
    const std::vector<std::string> files{"gradescope.json", "prairielearn.json", "classroom.json",
                                         "classroom.md",    "annotations.txt",   "autolab.txt",
                                         "junit.xml"};
    for (const std::string& file : files)
        ASSERT_TRUE(fs::exists(at("out/ann") / file)) << file;
    std::ofstream{at("class/ann/BumpySphere.cpp"), std::ios::app} << "// later\n";
    ASSERT_EQ(grade("--resume --results-only").status, 0);
    for (const std::string& file : files) {
        EXPECT_FALSE(fs::exists(at("out/ann") / file)) << file;
        EXPECT_TRUE(fs::exists(at("out/bob") / file)) << file << ", of a result that was kept";
    }
    EXPECT_FALSE(fs::exists(at("out/ann/student.html"))) << "written with the class";
    ASSERT_EQ(grade("--resume").status, 0);
    EXPECT_TRUE(fs::exists(at("out/ann/student.html")));
}

TEST_F(Verbs, DoctorNamesTheSandboxLevels) {
    const Ran ran = run("doctor");
    EXPECT_NE(ran.output.find("sandbox A"), std::string::npos) << ran.output;
    EXPECT_NE(ran.output.find("compiler"), std::string::npos);
}

}  // namespace
}  // namespace ticker::cli
