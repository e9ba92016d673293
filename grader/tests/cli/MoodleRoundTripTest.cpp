#include <grader/store/Store.h>
#include <grader/tests/support/MoodleImport.h>
#include <grader/tests/support/TemporaryFolder.h>

#include "RunTicker.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;
using tests::MoodleAssignment;
using tests::MoodleLayout;
using tests::MoodleStudent;

struct Case {
    const char* name;
    MoodleLayout layout;
};

void PrintTo(const Case& layout, std::ostream* stream) {
    *stream << layout.name;
}

std::string bytesOf(const fs::path& file) {
    std::ifstream stream{file, std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, {}};
}

tests::NamedBytes sampleFile(const std::string& sample, const std::string& file) {
    return {file, bytesOf(fs::path{TICKER_SOURCE_DIR} / "grader/corpus/samples" / sample / file)};
}

/// A class without anything to compile, which is fast to grade.
std::vector<MoodleStudent> someClass() {
    const tests::NamedBytes stub = sampleFile("notAwarded/template-untouched", "BumpySphere.cpp");
    const tests::NamedBytes picture = sampleFile("notAwarded/template-untouched", "screenshot.png");
    return {{"Ann_Lee <b>bold</b>", 12, {}, {stub, picture}},
            {"J\xC3\xBCrgen O'Neill, \"jr\"", 7, {}, {stub}},
            {"=HYPERLINK(1)", 4711, {}, {stub, picture}},
            {"\xE6\x9D\x8E \xE5\xB0\x8F\xE9\xBE\x99", 123, {}, {stub}, "<p>I typed, \"this\"</p>"}};
}

class MoodleRoundTrip : public testing::TestWithParam<Case> {
protected:
    [[nodiscard]] std::string at(const std::string& name) const {
        return (folder_.path() / name).string();
    }
    Ran run(const std::string& arguments) { return runTicker(arguments, at("errors")); }

    tests::TemporaryFolder folder_;
};

// Acceptance: ticker grades an export in each of Moodle's layouts and writes worksheet and feedback
// zip; Moodle accepts every row and every file.
TEST_P(MoodleRoundTrip, MoodleTakesEveryRowAndEveryFile) {
    const std::vector<MoodleStudent> people = someClass();
    MoodleAssignment moodle;
    moodle.blind = GetParam().layout.blind;
    for (const MoodleStudent& person : people)
        moodle.records[person.id] = {};
    tests::writeZip(at("CS-Tick 1-77.zip"), tests::moodleExport(people, GetParam().layout));
    folder_.write("sheet.csv", moodle.worksheet(people));

    const Ran ran = run("grade '" + at("CS-Tick 1-77.zip") + "' -o '" + at("out") +
                        "' --seed 7 --format moodle --worksheet '" + at("sheet.csv") + "'");
    ASSERT_EQ(ran.status, 0) << ran.errors;
    EXPECT_NE(ran.errors.find("fresh worksheet"), std::string::npos) << ran.errors;

    const auto fared = moodle.upload(bytesOf(at("out/moodle-worksheet.csv")), 1'760'000'000);
    ASSERT_EQ(fared.size(), people.size());
    for (const auto& [who, row] : fared)
        EXPECT_EQ(row, MoodleAssignment::Row::taken) << who;
    ASSERT_EQ(std::system(("LC_ALL=C.UTF-8 unzip -q -d '" + at("feedback") + "' '" +
                           at("out/moodle-feedback.zip") + "'")
                              .c_str()),
              0);
    for (const auto& entry : fs::recursive_directory_iterator{at("feedback")})
        if (entry.is_regular_file()) {
            EXPECT_TRUE(moodle.uploadFeedback(
                entry.path().lexically_relative(at("feedback")).generic_string()))
                << entry.path();
        }
    for (const auto& [id, record] : moodle.records) {
        EXPECT_EQ(record.grade, "0.00") << id;
        EXPECT_EQ(record.files, std::vector<std::string>{"student.html"}) << id;
    }
}

/// A decision on Ann's submission, and proposals for the others.
class MoodleDecisions : public MoodleRoundTrip {};

TEST_P(MoodleDecisions, AreToldFromProposalsWhichOneMayLeaveOut) {
    const std::vector<MoodleStudent> people = someClass();
    MoodleAssignment moodle;
    for (const MoodleStudent& person : people)
        moodle.records[person.id] = {};
    tests::writeZip(at("export.zip"), tests::moodleExport(people, GetParam().layout));
    folder_.write("sheet.csv", moodle.worksheet(people));
    ASSERT_EQ(run("grade '" + at("export.zip") + "' -o '" + at("out") + "' --seed 7").status, 0);
    {
        store::Store store{at("out")};
        Decision decision;
        decision.submission = store.results().front().submission;
        decision.version = 0;
        decision.ruling = Ruling::awarded;
        static_cast<void>(store.decide(decision));
    }
    const std::string report =
        "report '" + at("out") + "' --format moodle --worksheet '" + at("sheet.csv") + "'";
    const Ran all = run(report);
    ASSERT_EQ(all.status, 0) << all.errors;
    EXPECT_NE(all.errors.find("3 of the 4 marks are proposals of ticker"), std::string::npos)
        << all.errors;
    EXPECT_NE(all.errors.find("3 of the marks are 0"), std::string::npos) << all.errors;

    const Ran decided = run(report + " --decided-only");
    ASSERT_EQ(decided.status, 0) << decided.errors;
    EXPECT_EQ(decided.errors.find("proposal"), std::string::npos) << decided.errors;
    std::size_t taken = 0;
    for (const auto& [who, row] :
         moodle.upload(bytesOf(at("out/moodle-worksheet.csv")), 1'760'000'000))
        taken += row == MoodleAssignment::Row::taken ? 1 : 0;
    EXPECT_EQ(taken, 1U);
}

INSTANTIATE_TEST_SUITE_P(OneLayout, MoodleDecisions, testing::Values(Case{"folders", {}}),
                         [](const testing::TestParamInfo<Case>& chosen) {
                             return std::string{chosen.param.name};
                         });

INSTANTIATE_TEST_SUITE_P(
    AllLayouts, MoodleRoundTrip,
    testing::Values(Case{"folders", {}}, Case{"before41", {.trailingUnderscore = true}},
                    Case{"flat", {.folders = false}}, Case{"blind", {.blind = true}}),
    [](const testing::TestParamInfo<Case>& chosen) { return std::string{chosen.param.name}; });

}  // namespace
}  // namespace ticker::cli
