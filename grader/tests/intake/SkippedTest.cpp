#include <grader/intake/Skipped.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace ticker::intake {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> skippedIn(const fs::path& path) {
    std::vector<std::string> lines;
    for (const Skipped& skipped : findSkipped(path, findSubmissions(path)))
        lines.push_back(skipped.name + " " + skipped.why);
    return lines;
}

using Lines = std::vector<std::string>;

TEST(FindSkipped, TellsOfFoldersThatBeginWithADotAndOfEmptyOnes) {
    const tests::TemporaryFolder folder;
    folder.write("ann/Renderer.cpp", "x");
    folder.write(".eve/BumpySphere.cpp", "x");
    folder.write("..%2f../Renderer.cpp", "x");
    fs::create_directory(folder.path() / "cyd");
    EXPECT_EQ(skippedIn(folder.path()), (Lines{"..%2f.. its name begins with a dot",
                                               ".eve its name begins with a dot", "cyd is empty"}));
}

TEST(FindSkipped, TellsOfArchivesThatAreNotOpened) {
    const tests::TemporaryFolder folder;
    folder.write("ann/Renderer.cpp", "x");
    folder.write("bob.rar", "x");
    folder.write("cyd.zip", "x");
    folder.write("dee.7Z", "x");
    folder.write("eve.RAR", "x");
    EXPECT_EQ(
        skippedIn(folder.path()),
        (Lines{"bob.rar is no zip or tar", "dee.7Z is no zip or tar", "eve.RAR is no zip or tar"}));
}

TEST(FindSkipped, LooksBesideEverySubmissionOfAGroup) {
    const tests::TemporaryFolder folder;
    folder.write("monday/ann/Renderer.cpp", "x");
    folder.write("monday/.eve/Renderer.cpp", "x");
    folder.write("tuesday/bob/Renderer.cpp", "x");
    fs::create_directory(folder.path() / "tuesday/cyd");
    EXPECT_EQ(skippedIn(folder.path()),
              (Lines{"monday/.eve its name begins with a dot", "tuesday/cyd is empty"}));
}

TEST(FindSkipped, SaysNothingOfWhatIsInASubmissionOrWasLeftByASystem) {
    const tests::TemporaryFolder folder;
    folder.write("ann/Renderer.cpp", "x");
    folder.write("ann/.vscode/settings.json", "x");
    folder.write("__MACOSX/ann/._Renderer.cpp", "x");
    folder.write(".git/config", "x");
    folder.write("README.md", "x");
    EXPECT_EQ(skippedIn(folder.path()), Lines{});
    EXPECT_EQ(skippedIn(folder.path() / "ann"), Lines{});
}

TEST(FindSkipped, NamesAFolderInOneLine) {
    const tests::TemporaryFolder folder;
    folder.write("ann/Renderer.cpp", "x");
    fs::create_directory(folder.path() / "e\n::error::x");
    EXPECT_EQ(skippedIn(folder.path()), Lines{"e\xEF\xBF\xBD::error::x is empty"});
}

}  // namespace
}  // namespace ticker::intake
