#include "ExampleResults.h"

#include <grader/base/WholeFile.h>
#include <grader/report/SummaryCsv.h>
#include <grader/result/Names.h>
#include <grader/result/ProvenLine.h>
#include <grader/result/ResultJson.h>
#include <grader/tests/support/AsNobody.h>
#include <grader/tests/support/FitsSchema.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

namespace ticker::report {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

SubmissionResult example() {
    Finding finding;
    finding.id = "bump.inverted-u";
    finding.severity = Severity::fail;
    finding.message = "u is \x1B inverted <b>";
    finding.hint = "line 12";
    finding.section = "Option 1: Theory";
    finding.evidence = {{"matrix", std::vector<double>{-1.0, 0.0, 0.0, 1.0}},
                        {"points", 120.0},
                        {"worst", std::numeric_limits<double>::infinity()},
                        {"where", std::string{"latitude 40"}},
                        {"seam", true}};
    finding.plots = {{"lens",
                      "world units",
                      {{0.123456, -1e-9}, {std::nan(""), 2.0}},
                      ScatterPlot::Shape::disc,
                      0.4,
                      0.2,
                      RayDrawing{}}};
    RayDrawing& drawing = *finding.plots[0].drawing;
    drawing.about = "one <pixel>";
    drawing.words = {"50 \x1B rays"};
    drawing.spheres = {{"sphere 1", {0.0, 0.5, 4.0}, 1.0}};
    drawing.planes = {{"plane 1", {0.0, -1.0, 0.0}, {0.0, 1.0, 0.0}}};
    drawing.lights = {{"light 1", {0.0, 4.0, 2.0}, 0.4}};
    drawing.lensHalfWidth = 0.2;
    drawing.focalPlane = 3.5;
    drawing.rays = {{RayDrawing::Kind::blocked, {0.0, -1.0, 4.0}, {0.0, 1.0 / 3.0, 4.0}, "x", 0},
                    {RayDrawing::Kind::expected, {}, {std::nan(""), 0.0, 3.5}, "y", -1}};
    const RayDrawing::Point x{1.0, 0.0, 0.0};
    drawing.normals = {{{0.0, 0.0, 1.0 / 3.0}, x, x, x}, {x, x, std::nullopt, x}};
    drawing.outlines = {{x, {0.0, 1.0, 0.0}}};
    finding.rasters.resize(1);
    finding.rasters[0].title = "relief";
    finding.rasters[0].image = "images/T1-1.png";
    TaskReport t1{{TaskState::failed, "", {finding}, false}, "T1", "Bump mapping"};
    TaskReport shot{
        {TaskState::notAttempted, "there is none", {}, true}, "screenshot", "Screenshot"};
    SubmissionResult result;
    result.submission = "Zo\xC3\xAB, \"the\" =ray</td>";
    result.verdict = Verdict::notAwarded;
    result.option = "T1";
    result.seed = 18446744073709551615U;
    result.sandboxLevel = "A";
    result.toolVersion = "0.1.0";
    result.tasks = {t1, shot};
    result.renders = {{"bumpmap-test", 160, 120, 0.1, 0.9, 0.05, 3.0, 4.0, "images/a.png", "", ""}};
    result.renders[0].zMap = "images/a.zmap.png";
    result.tasks[1].plots = finding.plots;
    result.pictures = {{"images/T1-1.png", "relief", "bytes"}};
    result.notices = {"notes.txt was ignored"};
    result.diagnostics = {{"BumpySphere.cpp", "BumpySphere.cpp:1:1: error: \"[1, 2]\"\\"}};
    result.timing = {400.2, 31.0, 500.0};
    return result;
}

fs::path temporary(const std::string& name) {
    return fs::path{testing::TempDir()} / name;
}

// Any text from a student must not stop the batch.
TEST(ResultJson, IsValidWhateverTheTextsAre) {
    EXPECT_TRUE(json::accept(resultJson(hostileExample())));
}

TEST(ResultJson, FitsItsSchema) {
    EXPECT_TRUE(tests::fitsSchema(resultJson(example()), "result"));
    EXPECT_TRUE(tests::fitsSchema(resultJson(SubmissionResult{}), "result"));
    json wrong = json::parse(resultJson(example()));
    wrong["verdict"] = "maybe";
    EXPECT_FALSE(tests::fitsSchema(wrong.dump(), "result")) << "the schema must be able to refuse";
}

TEST(ResultJson, ComesBackAsItWentOut) {
    const fs::path file = temporary("result.json");
    writeAtomically(resultJson(example()), file);
    const SubmissionResult back = readResultJson(file);
    EXPECT_EQ(resultJson(back), resultJson(example()));
    EXPECT_EQ(back.seed, example().seed);
    EXPECT_EQ(back.tasks.at(0).findings.at(0).evidence.size(), 5U);
    EXPECT_TRUE(back.tasks.at(1).needsReview);
    EXPECT_EQ(back.diagnostics.at(0).text, example().diagnostics.at(0).text);
    fs::remove(file);
}

TEST(ResultJson, TakesOptionsOfAnyName) {
    SubmissionResult result = example();
    result.option = "bumps & dents";
    result.options = {{"bumps & dents", {"T1"}, 0.5}, {"light", {"T2.1", "T2.2"}, 1.0}};
    const std::string text = resultJson(result);
    EXPECT_TRUE(tests::fitsSchema(text, "result")) << text;
    const SubmissionResult back = parseResultJson(text, "result.json");
    EXPECT_EQ(back.option, "bumps & dents");
    ASSERT_EQ(back.options.size(), 2U);
    EXPECT_EQ(back.options[1].tasks, (std::vector<std::string>{"T2.1", "T2.2"}));
    EXPECT_EQ(back.options[0].points, 0.5);
}

TEST(ReadResultJson, NamesTheLine) {
    try {
        static_cast<void>(parseResultJson("{\n\"schemaVersion\":\n 99}", "result.json"));
        FAIL();
    } catch (const raytracer::InputError& error) {
        EXPECT_EQ(error.line(), 2) << error.what();
    }
}

TEST(ResultJson, KeepsAllThatAPageShows) {
    const fs::path file = temporary("pages.json");
    writeAtomically(resultJson(example()), file);
    const SubmissionResult back = readResultJson(file);
    const Finding& finding = back.tasks.at(0).findings.at(0);
    EXPECT_EQ(finding.plots.at(0).points.at(0).x, 0.1235) << "four digits are enough";
    EXPECT_EQ(finding.plots.at(0).otherHalfWidth, 0.2);
    ASSERT_TRUE(finding.plots.at(0).drawing);
    const RayDrawing& drawing = *finding.plots.at(0).drawing;
    EXPECT_EQ(drawing.about, "one <pixel>");
    EXPECT_EQ(drawing.spheres.at(0).centre[2], 4.0);
    EXPECT_EQ(drawing.planes.at(0).normal[1], 1.0);
    EXPECT_EQ(drawing.lights.at(0).radius, 0.4);
    EXPECT_EQ(drawing.lensHalfWidth, 0.2);
    EXPECT_EQ(drawing.focalPlane, 3.5);
    ASSERT_EQ(drawing.rays.size(), 2U);
    EXPECT_EQ(drawing.rays[0].kind, RayDrawing::Kind::blocked);
    EXPECT_EQ(drawing.rays[0].to[1], 0.3333);
    EXPECT_EQ(drawing.rays[0].light, 0);
    EXPECT_EQ(drawing.rays[1].to[0], 0.0) << "a drawing has finite ends alone";
    ASSERT_EQ(drawing.normals.size(), 2U);
    EXPECT_EQ(drawing.normals[0].at[2], 0.3333);
    ASSERT_TRUE(drawing.normals[0].expected);
    EXPECT_EQ((*drawing.normals[0].expected)[0], 1.0);
    EXPECT_FALSE(drawing.normals[1].expected);
    EXPECT_EQ(drawing.outlines.at(0).at(1)[1], 1.0);
    EXPECT_EQ(finding.rasters.at(0).image, "images/T1-1.png");
    EXPECT_TRUE(back.tasks.at(1).needsReview);
    EXPECT_EQ(back.pictures.at(0).caption, "relief");
    EXPECT_EQ(back.diagnostics.at(0).text, example().diagnostics.at(0).text);
    fs::remove(file);
}

TEST(ResultJson, WritesListsOfNumbersOnOneLine) {
    const std::string text = resultJson(example());
    EXPECT_NE(text.find("\"matrix\": [-1.0, 0.0, 0.0, 1.0]"), std::string::npos) << text;
    EXPECT_NE(text.find("\"points\": [[0.1235, -1e-09], [null, 2.0]]"), std::string::npos) << text;
}

TEST(ReadResultJson, TakesNoPictureFromElsewhere) {
    const fs::path file = temporary("elsewhere.json");
    for (const char* path : {"/etc/passwd", "images/../../x.png", "https://example.org/a.png"}) {
        json document = json::parse(resultJson(example()));
        document["pictures"][0]["file"] = path;
        std::ofstream{file} << document.dump();
        EXPECT_THROW(static_cast<void>(readResultJson(file)), raytracer::InputError) << path;
    }
    fs::remove(file);
}

TEST(ResultJson, HoldsNoControlCharacterAndNoNumberThatIsNone) {
    const json document = json::parse(resultJson(example()));
    const json& finding = document["tasks"][0]["findings"][0];
    EXPECT_EQ(finding["message"], "u is \xEF\xBF\xBD inverted <b>");
    EXPECT_TRUE(finding["evidence"]["worst"].is_null());
}

TEST(ReadResultJson, SaysWhatIsWrongInAnyFile) {
    const fs::path file = temporary("broken.json");
    const auto messageFor = [&](const std::string& text) {
        std::ofstream{file} << text;
        try {
            static_cast<void>(readResultJson(file));
        } catch (const raytracer::InputError& error) {
            return std::string{error.what()};
        }
        return std::string{"no error"};
    };
    EXPECT_NE(messageFor("").find("not JSON"), std::string::npos);
    EXPECT_NE(messageFor("[1]").find("schemaVersion"), std::string::npos);
    EXPECT_NE(messageFor(R"({"schemaVersion": 99})").find("/schemaVersion: expected 1"),
              std::string::npos);
    json document = json::parse(resultJson(example()));
    document["tasks"][0]["state"] = "great";
    EXPECT_NE(messageFor(document.dump()).find("/tasks/0/state"), std::string::npos);
    document = json::parse(resultJson(example()));
    document["seed"] = "12x";
    EXPECT_NE(messageFor(document.dump()).find("/seed"), std::string::npos);
    document = json::parse(resultJson(example()));
    document["score"] = nullptr;
    EXPECT_NE(messageFor(document.dump()).find("/score: expected a number"), std::string::npos);
    fs::remove(file);
    EXPECT_THROW(static_cast<void>(readResultJson(file)), raytracer::InputError);
}

TEST(ReadResultJson, SaysThatAFileCannotBeRead) {
    const tests::TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms{0755});
    const fs::path file = folder.write("result.json", resultJson(example()));
    fs::permissions(file, fs::perms::none);
    const tests::AsNobody nobody;
    try {
        static_cast<void>(readResultJson(file));
        FAIL() << "it was read";
    } catch (const raytracer::InputError& error) {
        EXPECT_EQ(error.what(), file.string() + ": cannot be read; expected a result.json");
    }
}

TEST(WriteAtomically, NamesTheFileThatCannotBeWritten) {
    try {
        writeAtomically("x", temporary("no-such-folder") / "a.json");
        FAIL() << "expected an error";
    } catch (const raytracer::InputError& error) {
        EXPECT_NE(std::string{error.what()}.find("no-such-folder"), std::string::npos);
    }
}

TEST(SummaryCsv, HasOneLineForEachSubmissionWithNamesDefused) {
    Exercise three = defaultExercise();
    three.tasks.resize(3);
    EXPECT_EQ(summaryCsv({example()}, {}, three),
              "submission,verdict,score,option,T1,T2.1,T2.2,screenshot,findings,ruling,decidedBy,"
              "decidedAt,comment\r\n"
              "\"Zo\xC3\xAB, \"\"the\"\" =ray</td>\",notAwarded,0,T1,failed,,,notAttempted,"
              "bump.inverted-u,,,,\r\n");
}

TEST(SummaryCsv, SaysWhatAPersonDecidedBesideWhatTheToolSays) {
    const auto lineAfter = [](const Decision& decision) {
        Decision another;
        another.submission = "somebody else";
        const std::string text = summaryCsv({example()}, {another, decision});
        return text.substr(text.find("bump.inverted-u"));
    };
    Decision decision{example().submission, 2,      Ruling::awarded,
                      "well, explained",    "=Ann", "2026-11-21T16:05:36Z",
                      Verdict::notAwarded};
    EXPECT_EQ(lineAfter(decision),
              "bump.inverted-u,awarded,'=Ann,2026-11-21T16:05:36Z,\"well, explained\"\r\n");
    decision.ruling = Ruling::undecided;
    EXPECT_EQ(lineAfter(decision).substr(0, 20), "bump.inverted-u,,'=A")
        << "undone, the comment stays";
    decision.comment.clear();
    EXPECT_EQ(lineAfter(decision), "bump.inverted-u,,,,\r\n");
}

TEST(ResultJson, KeepsProvenEditsAndDropsTheOthers) {
    SubmissionResult result = example();
    const Repair proven{
        "T1", "bump.inverted-u", "BumpySphere.cpp", {{3, "a", "b"}, {7, "c\nd", "e"}}, true, ""};
    Repair guessed = proven;
    guessed.proven = false;
    result.repairs = std::vector<Repair>{guessed, proven};
    const std::string text = resultJson(result);
    EXPECT_TRUE(tests::fitsSchema(text, "result")) << text;

    const SubmissionResult back = parseResultJson(text, "result.json");
    ASSERT_TRUE(back.repairs);
    ASSERT_EQ(back.repairs->size(), 1U);
    EXPECT_TRUE(back.repairs->front().proven);
    ASSERT_EQ(back.repairs->front().edits.size(), 2U);
    EXPECT_EQ(back.repairs->front().edits[1].line, 7);
    EXPECT_EQ(back.repairs->front().edits[1].from, "c\nd");
}

TEST(ProvenLines, AreThoseOfTheFirstProvenEditThatMakesATaskPass) {
    SubmissionResult result = example();
    EXPECT_TRUE(provenLines(result).empty()) << "edits were not looked for";
    const auto repair = [](const char* task, int line, bool proven, const char* next) {
        return Repair{task,   "",  "Own.cpp", {{line, "  a + \"b\"\n", "  a - \"b\"\n"}},
                      proven, next};
    };
    result.repairs = std::vector{repair("T1", 1, false, ""), repair("T1", 2, true, "bump.flat"),
                                 repair("T1", 3, true, ""), repair("T1", 4, true, "")};
    const std::vector<ProvenLine> lines = provenLines(result);
    EXPECT_EQ(lines, (std::vector<ProvenLine>{{"T1", "Own.cpp", 3, "a + \"b\"", "a - \"b\""}}));
    EXPECT_EQ(readProven(provenText(lines)), lines);
    EXPECT_EQ(provenText({}), "");
    EXPECT_TRUE(readProven("").empty());
    EXPECT_TRUE(readProven("{\"no\": 1}").empty());
}

TEST(ResultJson, TellsNoRepairsFromNotLookedFor) {
    SubmissionResult result = example();
    EXPECT_FALSE(parseResultJson(resultJson(result), "result.json").repairs);
    result.repairs.emplace();
    EXPECT_TRUE(parseResultJson(resultJson(result), "result.json").repairs);
}

}  // namespace
}  // namespace ticker::report
