#include <grader/intake/ClassExport.h>
#include <grader/intake/Intake.h>
#include <grader/tests/support/MoodleExport.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <set>

namespace ticker::intake {
namespace {

namespace fs = std::filesystem;
using tests::MoodleLayout;
using tests::MoodleStudent;
using tests::NamedBytes;

std::string zipOf(const std::vector<NamedBytes>& members) {
    const tests::TemporaryFolder folder;
    tests::writeZip(folder.path() / "work.zip", members);
    std::ifstream stream{folder.path() / "work.zip", std::ios::binary};
    return {std::istreambuf_iterator<char>{stream}, {}};
}

std::vector<MoodleStudent> somePeople() {
    return {
        {"J\xC3\xBCrgen O'Neill, jr", 7, {}, {{"src/Renderer.cpp", "jr"}, {"screenshot.png", "p"}}},
        {"Ann_Lee <b>", 12, {}, {{"BumpySphere.cpp", "ann"}, {"notes.pdf", "n"}}},
        {"Bob",
         123,
         {},
         {{"tick.zip", zipOf({{"w/Renderer.cpp", "bob"}, {"w/a.txt", "a"}})},
          {"screenshot.png", "q"}}},
        {"Cy", 9, {}, {}, "<p>I hand in nothing</p>"},
    };
}

const std::vector<MoodleLayout> kLayouts{
    {.folders = true}, {.folders = true, .trailingUnderscore = true}, {.folders = false}};

/// The submissions of an export by name, read as a zip or unpacked.
std::map<std::string, Submission> readExport(const std::vector<NamedBytes>& members, bool unpacked,
                                             const std::string& wrapper = {}) {
    const tests::TemporaryFolder folder;
    const fs::path place = folder.path() / (unpacked ? "CS-Tick 1-77" : "CS-Tick 1-77.zip");
    std::vector<NamedBytes> wrapped = members;
    for (NamedBytes& member : wrapped)
        member.path.insert(0, wrapper);
    if (unpacked)
        tests::writeFolder(place, wrapped);
    else
        tests::writeZip(place, wrapped);
    std::map<std::string, Submission> read;
    for (const Located& located : findSubmissions(place))
        read[located.name] = readSubmission(located);
    return read;
}

void expectSomePeople(std::map<std::string, Submission> read) {
    ASSERT_EQ(read.size(), 4U);
    const Submission& jr = read["J\xC3\xBCrgen ONeill, jr_7"];
    EXPECT_EQ(jr.part("Renderer.cpp"), "jr");
    EXPECT_EQ(jr.part("screenshot.png"), "p");
    EXPECT_TRUE(jr.findings.empty());
    EXPECT_EQ(read["Ann Lee b_12"].part("BumpySphere.cpp"), "ann");
    EXPECT_EQ(read["Ann Lee b_12"].ignored, std::vector<std::string>{"notes.pdf"});
    EXPECT_EQ(read["Bob_123"].part("Renderer.cpp"), "bob");
    EXPECT_EQ(read["Bob_123"].part("screenshot.png"), "q");
    EXPECT_EQ(read["Bob_123"].ignored, std::vector<std::string>{"tick.zip/w/a.txt"});
    ASSERT_EQ(read["Cy_9"].findings.size(), 1U);
    EXPECT_EQ(read["Cy_9"].findings[0].finding.id, "intake.missing-file");
    EXPECT_EQ(read["Cy_9"].ignored, std::vector<std::string>{"onlinetext/onlinetext.html"});
}

TEST(MoodleExport, IsReadInEveryLayoutAsAZipAndUnpacked) {
    for (const MoodleLayout& layout : kLayouts)
        for (const bool unpacked : {false, true}) {
            SCOPED_TRACE(testing::Message()
                         << layout.folders << layout.trailingUnderscore << unpacked);
            expectSomePeople(readExport(tests::moodleExport(somePeople(), layout), unpacked));
        }
}

TEST(MoodleExport, IsReadBelowTheFolderThatAnUnpackerOrRepackerMade) {
    for (const bool unpacked : {false, true})
        expectSomePeople(readExport(tests::moodleExport(somePeople()), unpacked, "CS-Tick/"));
}

TEST(MoodleExport, KeepsNumbersUnderBlindMarkingAndGroupsInNames) {
    for (const MoodleLayout& layout : kLayouts) {
        MoodleLayout blind = layout;
        blind.blind = true;
        const auto read = readExport(tests::moodleExport(somePeople(), blind), false);
        EXPECT_TRUE(read.contains("Participant_7") && read.contains("Participant_123"));
        const std::vector<MoodleStudent> teams{{"Ann", 3, "Team A", {{"Renderer.cpp", "x"}}},
                                               {"Default group", 0, {}, {{"Renderer.cpp", "y"}}}};
        const auto teamed = readExport(tests::moodleExport(teams, layout), true);
        ASSERT_EQ(teamed.size(), 2U);
        EXPECT_EQ(teamed.at("Team A-Ann_3").part("Renderer.cpp"), "x");
        EXPECT_EQ(teamed.at("Default group").part("Renderer.cpp"), "y");
    }
}

TEST(MoodleExport, LetsNobodyHandInForSomebodyElse) {
    const std::vector<NamedBytes> members{
        {"Ann_1_assignsubmission_file/Bob_2_assignsubmission_file/Renderer.cpp", "ann"},
        {"Bob_2_assignsubmission_file/Renderer.cpp", "bob"}};
    for (const bool unpacked : {false, true}) {
        const auto read = readExport(members, unpacked);
        ASSERT_EQ(read.size(), 2U);
        EXPECT_EQ(read.at("Ann_1").part("Renderer.cpp"), "ann");
        EXPECT_EQ(read.at("Bob_2").part("Renderer.cpp"), "bob");
    }
}

TEST(MoodleExport, KeepsTheIdOfAVeryLongName) {
    const std::vector<MoodleStudent> people{
        {std::string(300, 'x'), 4711, {}, {{"Renderer.cpp", "x"}}}};
    const tests::TemporaryFolder folder;
    tests::writeZip(folder.path() / "e.zip", tests::moodleExport(people));
    const auto located = findSubmissions(folder.path() / "e.zip");
    ASSERT_EQ(located.size(), 1U);
    EXPECT_EQ(located[0].name, std::string(95, 'x') + "_4711");
    EXPECT_EQ(readSubmission(located[0]).part("Renderer.cpp"), "x");
}

TEST(MoodleExport, IsNoneWhereOnlyTheWordsComeInAName) {
    EXPECT_FALSE(readExportedPath("_assignsubmission_file/Renderer.cpp"));
    EXPECT_FALSE(readExportedPath("Ann_1_assignsubmission_/Renderer.cpp"));
    EXPECT_FALSE(readExportedPath("Ann_1_assignfeedback_file/Renderer.cpp"));
    EXPECT_FALSE(readExportedPath("__MACOSX/._Ann_1_assignsubmission_file_Renderer.cpp"));
    EXPECT_FALSE(readExportedPath("work/src/Ann_1_assignsubmission_file/Renderer.cpp"));
}

TEST(MoodleExport, IsNotMadeOfAClassByOneFolderThatIsNamedSo) {
    const std::vector<NamedBytes> members{{"ann/Renderer.cpp", "ann"},
                                          {"bob/Renderer.cpp", "bob"},
                                          {"mallory_1_assignsubmission_file_/Renderer.cpp", "m"}};
    const auto read = readExport(members, true);
    ASSERT_EQ(read.size(), 3U);
    EXPECT_EQ(read.at("ann").part("Renderer.cpp"), "ann");
    EXPECT_EQ(read.at("bob").part("Renderer.cpp"), "bob");
    const auto zipped = readExport(members, false);
    ASSERT_EQ(zipped.size(), 1U);
    EXPECT_EQ(zipped.begin()->second.findings.at(0).finding.id, "intake.ambiguous");
}

TEST(MoodleExport, InTheFolderOfAStudentDoesNotRenameHim) {
    const std::vector<NamedBytes> members{
        {"aaron/zoe_1_assignsubmission_file_/Renderer.cpp", "aaron"}, {"zoe/Renderer.cpp", "zoe"}};
    const auto read = readExport(members, true);
    ASSERT_EQ(read.size(), 2U);
    EXPECT_EQ(read.at("aaron").part("Renderer.cpp"), "aaron");
    EXPECT_EQ(read.at("zoe").part("Renderer.cpp"), "zoe");
}

TEST(MoodleExport, IsReadBesideTheZipThatItCameIn) {
    const tests::TemporaryFolder folder;
    tests::writeZip(folder.path() / "CS-Tick.zip", tests::moodleExport(somePeople()));
    tests::writeFolder(folder.path() / "CS-Tick", tests::moodleExport(somePeople()));
    folder.write("notes/marking.txt", "n");
    std::set<std::string> names;
    for (const Located& located : findSubmissions(folder.path()))
        names.insert(located.name);
    EXPECT_EQ(names, (std::set<std::string>{"Ann Lee b_12", "Bob_123", "CS-Tick", "Cy_9",
                                            "J\xC3\xBCrgen ONeill, jr_7", "notes"}));
}

TEST(MoodleExport, DropsNobodyWhoseFolderDoesNotFit) {
    std::vector<NamedBytes> members = tests::moodleExport(somePeople());
    members.push_back({"late/src/Renderer.cpp", "late"});
    members.push_back({"later.zip", zipOf({{"Renderer.cpp", "later"}})});
    members.push_back({"__MACOSX/._Renderer.cpp", "x"});
    for (const bool unpacked : {false, true}) {
        auto read = readExport(members, unpacked);
        ASSERT_EQ(read.size(), 6U);
        EXPECT_EQ(read.at("late").part("Renderer.cpp"), "late");
        EXPECT_EQ(read.at("later").part("Renderer.cpp"), "later");
        read.erase("late");
        read.erase("later");
        expectSomePeople(read);
    }
}

TEST(ReadSubmission, OpensAZipOnlyWhereNoCodeLiesBesideIt) {
    const tests::TemporaryFolder folder;
    tests::writeFolder(folder.path() / "ann",
                       {{"old.zip", zipOf({{"Renderer.cpp", "old"}})}, {"Renderer.cpp", "new"}});
    tests::writeFolder(folder.path() / "bob", {{"a.zip", zipOf({{"Renderer.cpp", "1"}})},
                                               {"b.zip", zipOf({{"Renderer.cpp", "2"}})}});
    const Submission ann = readSubmission({"ann", folder.path() / "ann"});
    EXPECT_EQ(ann.part("Renderer.cpp"), "new");
    EXPECT_EQ(ann.ignored, std::vector<std::string>{"old.zip"});
    const Submission bob = readSubmission({"bob", folder.path() / "bob"});
    ASSERT_EQ(bob.findings.size(), 1U);
    EXPECT_EQ(bob.findings[0].finding.id, "intake.ambiguous");
}

TEST(ReadSubmission, RefusesABrokenZipThatHoldsTheOnlyCode) {
    const tests::TemporaryFolder folder;
    folder.write("ann/work.zip", "PK\x03\x04 and no more");
    const Submission ann = readSubmission({"ann", folder.path() / "ann"});
    ASSERT_FALSE(ann.findings.empty());
    EXPECT_EQ(ann.findings[0].finding.id, "intake.unsafe-archive");
}

}  // namespace
}  // namespace ticker::intake
