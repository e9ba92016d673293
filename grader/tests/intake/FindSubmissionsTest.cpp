#include <grader/intake/Intake.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

namespace ticker::intake {
namespace {

std::vector<std::string> namesIn(const std::filesystem::path& path) {
    std::vector<std::string> names;
    for (const Located& located : findSubmissions(path))
        names.push_back(located.name);
    return names;
}

using Names = std::vector<std::string>;

TEST(FindSubmissions, TakesAFolderWithTheFilesAsOne) {
    const tests::TemporaryFolder folder;
    folder.write("ann/Renderer.cpp", "x");
    folder.write("ann/old/Renderer.cpp", "y");
    EXPECT_EQ(namesIn(folder.path() / "ann"), Names{"ann"});
}

TEST(FindSubmissions, TakesAClassOfFoldersAndArchives) {
    const tests::TemporaryFolder folder;
    folder.write("ann/Renderer.cpp", "x");
    folder.write("bob.zip", "x");
    folder.write("cy/Renderer.cpp", "x");
    folder.write("notes.txt", "x");
    EXPECT_EQ(namesIn(folder.path()), (Names{"ann", "bob", "cy"}));
}

TEST(FindSubmissions, ForgetsNobodyWhoMisnamedHisFiles) {
    const tests::TemporaryFolder folder;
    folder.write("ann/Renderer.cpp", "x");
    folder.write("bob/tick1.cpp", "x");
    std::filesystem::create_directory(folder.path() / "empty");
    EXPECT_EQ(namesIn(folder.path()), (Names{"ann", "bob"}));
}

TEST(FindSubmissions, LooksSeveralLevelsDeep) {
    const tests::TemporaryFolder folder;
    folder.write("awarded/one/Renderer.cpp", "x");
    folder.write("awarded/two/BumpySphere.cpp", "x");
    folder.write("needsReview/three/BumpySphere.cpp", "x");
    EXPECT_EQ(namesIn(folder.path()), (Names{"one", "two", "three"}));
}

TEST(FindSubmissions, NamesAStudentAfterHisFolderNotAfterWhatIsInIt) {
    const tests::TemporaryFolder folder;
    folder.write("ann/tick/Renderer.cpp", "x");
    folder.write("bob/tick/Renderer.cpp", "x");
    folder.write("cy/Renderer.cpp", "x");
    folder.write("dee/work.zip", "x");
    EXPECT_EQ(namesIn(folder.path()), (Names{"ann", "bob", "cy", "dee"}));
}

TEST(FindSubmissions, TakesOneWorkOverSeveralFoldersAsOne) {
    const tests::TemporaryFolder folder;
    folder.write("ann/src/Renderer.cpp", "x");
    folder.write("ann/pictures/screenshot.png", "x");
    EXPECT_EQ(namesIn(folder.path() / "ann"), Names{"ann"});
}

TEST(FindSubmissions, TakesTheWholeKitAsOne) {
    const tests::TemporaryFolder folder;
    for (const std::string kit : {"ann/", "bob/tick1star/"}) {
        folder.write(kit + "exercise/BumpySphere.cpp", "x");
        folder.write(kit + "exercise/Renderer.cpp", "x");
        folder.write(kit + "framework/src/geometry/BumpySphere.cpp", "x");
        folder.write(kit + "framework/src/math/Random.cpp", "x");
        folder.write(kit + "tests/CMakeLists.txt", "x");
    }
    EXPECT_EQ(namesIn(folder.path()), (Names{"ann", "bob"}));
    EXPECT_EQ(namesIn(folder.path() / "ann"), Names{"ann"});
}

TEST(FindSubmissions, DoesNotMakeOneOutOfTwoPeople) {
    const tests::TemporaryFolder folder;
    folder.write("class/ann/BumpySphere.cpp", "x");
    folder.write("class/bob/screenshot.png", "x");
    folder.write("class/bob/old/Renderer.cpp", "x");
    folder.write("class/bob/new/Renderer.cpp", "x");
    EXPECT_EQ(namesIn(folder.path() / "class"), (Names{"ann", "bob"}));
    std::filesystem::remove_all(folder.path() / "class/bob");
    folder.write("class/bob/Renderer.cpp", "x");
    EXPECT_EQ(namesIn(folder.path() / "class"), (Names{"ann", "bob"}));
}

TEST(FindSubmissions, DoesNotMakeOneOutOfAClassWithOneWhoHandedInAPictureAlone) {
    const tests::TemporaryFolder folder;
    folder.write("ann/BumpySphere.cpp", "x");
    folder.write("mallory/screenshot.png", "x");
    EXPECT_EQ(namesIn(folder.path()), (Names{"ann", "mallory"}));
    folder.write("bob/Renderer.cpp", "x");
    EXPECT_EQ(namesIn(folder.path()), (Names{"ann", "bob", "mallory"}));
}

TEST(FindSubmissions, DoesNotMakeAKitOutOfTwoFoldersOfAClass) {
    const tests::TemporaryFolder folder;
    folder.write("exercise/BumpySphere.cpp", "x");
    folder.write("framework/src/Renderer.cpp", "x");
    folder.write("ann/Renderer.cpp", "x");
    EXPECT_EQ(namesIn(folder.path()), (Names{"ann", "exercise", "framework"}));
    folder.write("bob.zip", "x");
    EXPECT_EQ(namesIn(folder.path()), (Names{"ann", "bob", "exercise", "framework"}));
}

TEST(FindSubmissions, GivesEachItsOwnName) {
    const tests::TemporaryFolder folder;
    folder.write("monday/ann/Renderer.cpp", "x");
    folder.write("monday/bob/Renderer.cpp", "x");
    folder.write("tuesday/ann/Renderer.cpp", "x");
    folder.write("tuesday/cy/Renderer.cpp", "x");
    EXPECT_EQ(namesIn(folder.path()), (Names{"ann", "bob", "ann-2", "cy"}));
}

TEST(FindSubmissions, NamesTheOthersAfterTheirFoldersWhereOneHoldsSeveral) {
    const tests::TemporaryFolder folder;
    for (const std::string place : {"ann/exercise", "bob/exercise", "mallory/a", "mallory/b"})
        folder.write(place + "/Renderer.cpp", "x");
    folder.write("dee/tick1.cpp", "x");
    EXPECT_EQ(namesIn(folder.path()), (Names{"ann", "bob", "dee", "mallory-a", "mallory-b"}));
}

TEST(FindSubmissions, LetsNobodyTakeTheNameOfAnotherFolderOfTheClass) {
    const tests::TemporaryFolder folder;
    for (const std::string place : {"aaron/zoe", "aaron/yan", "zoe", "yan", "-yan", "aaron-zoe"})
        folder.write(place + "/Renderer.cpp", "x");
    folder.write("xan.zip", "x");
    EXPECT_EQ(namesIn(folder.path()),
              (Names{"yan-2", "aaron-yan", "aaron-zoe-2", "aaron-zoe", "xan", "yan", "zoe"}));
}

TEST(FindSubmissions, GivesNamesThatAreFitForFolders) {
    const tests::TemporaryFolder folder;
    folder.write("..ann:<b>\n/Renderer.cpp", "x");
    folder.write("-rf/Renderer.cpp", "x");
    folder.write(std::string(200, 'x') + "/Renderer.cpp", "x");
    folder.write("J\xC3\xBCrgen, =1+1/Renderer.cpp", "x");
    EXPECT_EQ(namesIn(folder.path()), (Names{"rf", "J\xC3\xBCrgen, =1+1", std::string(100, 'x')}));
}

TEST(FindSubmissions, GivesNoNameThatAFileOfTheResultsBears) {
    const tests::TemporaryFolder folder;
    for (const char* name : {"Index.HTML", "results.sqlite", "results.sqlite-wal", "seed",
                             "summary.csv", "task-7.log"})
        folder.write(std::string{name} + "/Renderer.cpp", "x");
    folder.write("results.json.zip", "x");
    folder.write("similar.html.zip", "x");
    folder.write("Canvas-Gradebook.csv/Renderer.cpp", "x");
    EXPECT_EQ(namesIn(folder.path()),
              (Names{"Canvas-Gradebook.csv-submission", "Index.HTML-submission",
                     "results.json-submission", "results.sqlite-submission",
                     "results.sqlite-wal-submission", "seed-submission", "similar.html-submission",
                     "summary.csv-submission", "task-7.log-submission"}));
}

TEST(FindSubmissions, TakesAnyFolderThatWasNamedByItself) {
    const tests::TemporaryFolder folder;
    EXPECT_EQ(findSubmissions(folder.path()).size(), 1U);
}

TEST(FindSubmissions, SaysWhatIsWrongWithAPath) {
    const tests::TemporaryFolder folder;
    folder.write("a.txt", "x");
    EXPECT_THROW(static_cast<void>(findSubmissions("/nowhere")), raytracer::InputError);
    EXPECT_THROW(static_cast<void>(findSubmissions(folder.path() / "a.txt")),
                 raytracer::InputError);
}

}  // namespace
}  // namespace ticker::intake
