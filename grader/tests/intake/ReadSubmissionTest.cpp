#include <grader/intake/Intake.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <sys/stat.h>

#include <algorithm>
#include <string>
#include <vector>

namespace ticker::intake {
namespace {

Submission read(const tests::TemporaryFolder& folder) {
    return readSubmission({"somebody", folder.path()});
}

std::string idOf(const Submission& submission, std::string_view part) {
    const Finding* finding = submission.refusalOf(part);
    return finding == nullptr ? "" : finding->id;
}

TEST(ReadSubmission, FindsTheThreeFilesInNestedFoldersAndListsTheRest) {
    const tests::TemporaryFolder folder;
    folder.write("work/src/BumpySphere.cpp", "bump");
    folder.write("work/src/Renderer.cpp", "render");
    folder.write("work/screenshot.png", "picture");
    folder.write("work/notes.txt", "notes");
    folder.write("__MACOSX/work/src/._BumpySphere.cpp", "litter");

    const Submission submission = read(folder);

    EXPECT_EQ(submission.name, "somebody");
    EXPECT_EQ(submission.part("BumpySphere.cpp"), "bump");
    EXPECT_EQ(submission.part("Renderer.cpp"), "render");
    EXPECT_EQ(submission.part("screenshot.png"), "picture");
    EXPECT_TRUE(submission.findings.empty());
    EXPECT_EQ(submission.ignored, (std::vector<std::string>{"__MACOSX", "work/notes.txt"}));
}

TEST(ReadSubmission, KeepsTheOriginalBytes) {
    const tests::TemporaryFolder folder;
    const std::string bytes = "\xEF\xBB\xBF// CRLF\r\nint x;\r\n";
    folder.write("Renderer.cpp", bytes);
    EXPECT_EQ(read(folder).part("Renderer.cpp"), bytes);
}

TEST(ReadSubmission, UnderstandsWhatBrowsersDoToNames) {
    for (const char* name :
         {"bumpysphere.CPP", "BumpySphere (1).cpp", "BumpySphere-2.cpp", "BumpySphere - Copy.cpp",
          " BumpySphere.cpp ", "BumpySphere.cpp.txt"}) {
        const tests::TemporaryFolder folder;
        folder.write(name, "bump");
        EXPECT_EQ(read(folder).part("BumpySphere.cpp"), "bump") << name;
    }
}

TEST(ReadSubmission, TakesOtherEndingsOfTheSameLanguage) {
    for (const char* name : {"BumpySphere.cc", "BumpySphere.cxx", "BumpySphere (1).CC"}) {
        const tests::TemporaryFolder folder;
        folder.write(name, "bump");
        EXPECT_EQ(read(folder).part("BumpySphere.cpp"), "bump") << name;
    }
}

TEST(ReadSubmission, LeavesOutTheKitsOwnFileOfTheSameName) {
    const tests::TemporaryFolder folder;
    folder.write("tick/exercise/BumpySphere.cpp", "bump");
    folder.write("tick/framework/src/geometry/BumpySphere.cpp", "constructor");
    const Submission submission = read(folder);
    EXPECT_EQ(submission.part("BumpySphere.cpp"), "bump");
    EXPECT_TRUE(submission.findings.empty());
    EXPECT_EQ(submission.ignored,
              std::vector<std::string>{"tick/framework/src/geometry/BumpySphere.cpp"});
}

TEST(ReadSubmission, SuggestsTheNearestNameWhenOneIsMissing) {
    const tests::TemporaryFolder folder;
    folder.write("BumpSphere.cpp", "bump");

    const Submission submission = read(folder);

    ASSERT_EQ(submission.findings.size(), 1U);
    EXPECT_EQ(submission.findings[0].finding.id, "intake.missing-file");
    EXPECT_EQ(submission.findings[0].part, "BumpySphere.cpp");
    EXPECT_NE(submission.findings[0].finding.hint.find("BumpSphere.cpp"), std::string::npos);
}

TEST(ReadSubmission, SaysSoWhereThereIsNoSourceAtAll) {
    const tests::TemporaryFolder folder;
    folder.write("essay.docx", "text");
    const Submission submission = read(folder);
    EXPECT_EQ(idOf(submission, "Renderer.cpp"), "intake.missing-file");
    EXPECT_EQ(idOf(submission, "BumpySphere.cpp"), "intake.missing-file");
}

TEST(ReadSubmission, MissesNothingWhereOneOptionWasChosen) {
    const tests::TemporaryFolder folder;
    folder.write("Renderer.cpp", "render");
    EXPECT_TRUE(read(folder).findings.empty());
}

TEST(ReadSubmission, NeverChoosesBetweenTwoThatDiffer) {
    const tests::TemporaryFolder folder;
    folder.write("old/Renderer.cpp", "one");
    folder.write("new/Renderer.cpp", "two");
    folder.write("BumpySphere.cpp", "bump");

    const Submission submission = read(folder);

    EXPECT_EQ(idOf(submission, "Renderer.cpp"), "intake.ambiguous");
    EXPECT_FALSE(submission.part("Renderer.cpp"));
    EXPECT_EQ(idOf(submission, "BumpySphere.cpp"), "");
    EXPECT_EQ(submission.part("BumpySphere.cpp"), "bump");
}

TEST(ReadSubmission, AsksAboutNamesThatDifferInCaseOnly) {
    const tests::TemporaryFolder folder;
    folder.write("Renderer.cpp", "one");
    folder.write("renderer.cpp", "two");
    EXPECT_EQ(idOf(read(folder), "Renderer.cpp"), "intake.ambiguous");
}

TEST(ReadSubmission, TakesEqualCopiesAsOne) {
    const tests::TemporaryFolder folder;
    folder.write("a/Renderer.cpp", "same");
    folder.write("b/Renderer.cpp", "same");
    const Submission submission = read(folder);
    EXPECT_EQ(submission.part("Renderer.cpp"), "same");
    EXPECT_TRUE(submission.findings.empty());
}

TEST(ReadSubmission, RefusesWhatIsNoText) {
    using namespace std::string_literals;
    for (const std::string& bytes : {"\xFF\xFEi\0n\0t\0"s, "int\0x;"s,
                                     "\x7F"
                                     "ELF\0\0\0"s}) {
        const tests::TemporaryFolder folder;
        folder.write("Renderer.cpp", bytes);
        EXPECT_EQ(idOf(read(folder), "Renderer.cpp"), "intake.not-text");
    }
}

TEST(ReadSubmission, RefusesASourceOverTheLimitAndTakesOneAtIt) {
    const tests::TemporaryFolder folder;
    folder.write("Renderer.cpp", std::string(256U << 10U, ' '));
    EXPECT_EQ(idOf(read(folder), "Renderer.cpp"), "");
    folder.write("Renderer.cpp", std::string((256U << 10U) + 1, ' '));
    EXPECT_EQ(idOf(read(folder), "Renderer.cpp"), "intake.too-large");
}

TEST(ReadSubmission, AsksForWhatItsExerciseHas) {
    IntakeLimits main;
    main.exercise = &exerciseNamed("tick1");
    const tests::TemporaryFolder folder;
    const auto hint = [&](const IntakeLimits& limits) {
        return readSubmission({"somebody", folder.path()}, limits).findings.at(0).finding.hint;
    };
    EXPECT_EQ(hint(main), "Hand in Sphere.cpp, Renderer.cpp and Plane.cpp.");
    EXPECT_EQ(hint({}), "Hand in the file of the option that you chose, and screenshot.png.");
    folder.write("Renderer.cpp", std::string((256U << 10U) + 1, ' '));
    EXPECT_EQ(hint(main), "Hand in the file that you wrote.");
    EXPECT_EQ(hint({}), "Hand in the file that you wrote, and the picture as tick1star writes it.");
}

TEST(ReadSubmission, RefusesALinkAndAPipe) {
    const tests::TemporaryFolder folder;
    std::filesystem::create_symlink("/etc/passwd", folder.path() / "Renderer.cpp");
    ASSERT_EQ(mkfifo((folder.path() / "BumpySphere.cpp").c_str(), 0600), 0);
    const Submission submission = read(folder);
    EXPECT_EQ(idOf(submission, "Renderer.cpp"), "intake.unsafe-archive");
    EXPECT_EQ(idOf(submission, "BumpySphere.cpp"), "intake.unsafe-archive");
    EXPECT_FALSE(submission.part("Renderer.cpp"));
}

TEST(ReadSubmission, DoesNotFollowLinksToFolders) {
    const tests::TemporaryFolder folder;
    folder.write("Renderer.cpp", "render");
    std::filesystem::create_directory_symlink("..", folder.path() / "up");
    const Submission submission = read(folder);
    EXPECT_EQ(submission.part("Renderer.cpp"), "render");
    EXPECT_EQ(submission.ignored, std::vector<std::string>{"up"});
}

// Names reach the ticker's terminal and the pages.
TEST(ReadSubmission, ShowsNamesWithoutTheirControlCharacters) {
    const tests::TemporaryFolder folder;
    folder.write("\x1b[31m/Renderer.cpp", "one");
    folder.write("\x1b[32m/Renderer.cpp", "two");
    folder.write("\x1b[33m\n/BumpSphere.cpp", "bump");
    folder.write("a\x1b[2J\r\nb.txt", "notes");
    const Submission submission = read(folder);
    EXPECT_EQ(idOf(submission, "Renderer.cpp"), "intake.ambiguous");
    EXPECT_EQ(idOf(submission, "BumpySphere.cpp"), "intake.missing-file");
    EXPECT_EQ(submission.ignored.size(), 2U);
    std::vector<std::string> shown = submission.ignored;
    for (const IntakeFinding& found : submission.findings)
        shown.push_back(found.finding.message + found.finding.hint);
    for (const std::string& text : shown)
        EXPECT_TRUE(std::ranges::none_of(text, [](char c) {
            return static_cast<unsigned char>(c) < ' ' || c == '\x7f';
        })) << text;
}

TEST(ReadSubmission, StopsCountingFiles) {
    const tests::TemporaryFolder folder;
    for (int i = 0; i < 40; ++i)
        folder.write("many/" + std::to_string(i), "");
    folder.write("Renderer.cpp", "render");
    IntakeLimits limits;
    limits.members = 20;
    const Submission submission = readSubmission({"somebody", folder.path()}, limits);
    EXPECT_EQ(idOf(submission, "Renderer.cpp"), "intake.too-large");
}

}  // namespace
}  // namespace ticker::intake
