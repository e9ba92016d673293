// The verbs for data that an instructor changes: selftest, refs, package.
#include <grader/exercise/Exercise.h>
#include <grader/tests/support/Files.h>
#include <grader/tests/support/TemporaryFolder.h>

#include "RunTicker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

/// Edits that fit the reference: a mistake that the grader calls bump.inverted-u.
const std::string kFitting = R"json({"find": "normal + Bu * normal.cross(Pv)",
  "replace": "normal - Bu * normal.cross(Pv)"})json";

/// A project of links to this one, except for the files that instructors add to.
class LabVerbs : public testing::Test {
protected:
    LabVerbs() {
        for (const char* name : {"assets", "reference_solution", "docs", "student_template"})
            link(name);
        fs::create_directories(home() / "grader");
        for (const char* name : {"grader/rubric", "grader/report", "grader/corpus/samples"})
            link(name);
        fs::copy(kRoot / "scenes", home() / "scenes");
        for (const char* name : {"T1/inverted-u", "T1/inverted-v", "T2.1/hard-centre"})
            keep("grader/corpus/mistakes/" + std::string{name} + ".json");
        setenv("TICKER_HOME", home().c_str(), 1);
    }
    ~LabVerbs() override { unsetenv("TICKER_HOME"); }
    LabVerbs(const LabVerbs&) = delete;
    LabVerbs& operator=(const LabVerbs&) = delete;

    [[nodiscard]] fs::path home() const { return folder_.path() / "home"; }

    /// @param about  Its member "about", and other members of the entry.
    void addMistake(const std::string& task, const std::string& id, const std::string& edit,
                    const std::string& finding = "bump.inverted-u",
                    const std::string& about = R"("about": "t")") const {
        const std::string file = task == "T1" ? "BumpySphere.cpp" : "Renderer.cpp";
        folder_.write("home/grader/corpus/mistakes/" + task + "/" + id + ".json",
                      "{" + about + R"(, "base": "reference", "edits": {")" + file + "\": [" +
                          edit + R"(]}, "expect": {")" + task +
                          R"(": {"state": "failed", "findings": [")" + finding + "\"]}}}");
    }

    [[nodiscard]] Ran run(const std::string& arguments) const {
        return runTicker(arguments, (folder_.path() / "errors").string());
    }
    [[nodiscard]] Ran runLab(const std::string& arguments) const {
        return runTicker(arguments, (folder_.path() / "errors").string(), "ticker-lab");
    }

    tests::TemporaryFolder folder_;

private:
    void link(const std::string& name) const {
        fs::create_directories((home() / name).parent_path());
        fs::create_symlink(kRoot / name, home() / name);
    }
    void keep(const std::string& name) const {
        folder_.write("home/" + name, tests::readFile(name));
    }

    const fs::path kRoot = TICKER_SOURCE_DIR;
};

TEST_F(LabVerbs, SelftestJudgesOneMistakeOfEitherTask) {
    const Ran ran = runLab("selftest --case inverted-u,T2.1/hard-centre");
    EXPECT_EQ(ran.status, 0) << ran.output << ran.errors;
    EXPECT_NE(ran.output.find("T1    inverted-u"), std::string::npos) << ran.output;
    EXPECT_NE(ran.output.find("2 entries, 0 not as expected"), std::string::npos) << ran.output;
}

TEST_F(LabVerbs, SelftestNamesTheNearestMistake) {
    const Ran ran = runLab("selftest --case inverted-uu");
    EXPECT_EQ(ran.status, 2);
    EXPECT_NE(ran.errors.find("did you mean inverted-u?"), std::string::npos) << ran.errors;
}

TEST_F(LabVerbs, SelftestSaysWhatATaskOneEntryGivesInsteadOfWhatItExpects) {
    addMistake("T1", "other-name", kFitting, "bump.inverted-v");
    const Ran ran = runLab("selftest --task T1 --case other-name");
    EXPECT_EQ(ran.status, 1);
    EXPECT_NE(ran.output.find("saw: failed bump.inverted-u"), std::string::npos) << ran.output;
}

TEST_F(LabVerbs, SelftestSaysThatAnEntryDoesNotCompile) {
    addMistake("T1", "broken", R"({"find": "const HeightMap& map", "replace": "oops"})");
    const Ran ran = runLab("selftest --case broken");
    EXPECT_EQ(ran.status, 1);
    EXPECT_NE(ran.output.find("saw: does not compile: "), std::string::npos) << ran.output;
}

// Selected or not, and for each task.
TEST_F(LabVerbs, SelftestRefusesAnEntryThatDoesNotFit) {
    for (const std::string task : {"T1", "T2.1"}) {
        addMistake(task, "zz-misfit", R"({"find": "no such line", "replace": ""})");
        const Ran ran = runLab("selftest --task " + task.substr(0, 2) + " --fraction 0.01");
        EXPECT_EQ(ran.status, 2) << ran.output;
        EXPECT_NE(
            ran.errors.find(task + "/zz-misfit.json: \"edits\"[0]: its \"find\" must stand once"),
            std::string::npos)
            << ran.errors;
        fs::remove(home() / "grader/corpus/mistakes" / task / "zz-misfit.json");
    }
}

TEST_F(LabVerbs, SelftestRefusesAnUnknownMember) {
    addMistake("T1", "typing-mistake", kFitting, "bump.inverted-u",
               R"("titel": "t", "about": "t")");
    const Ran ran = runLab("selftest --task T1 --fraction 0.01");
    EXPECT_EQ(ran.status, 2) << ran.output;
    EXPECT_NE(ran.errors.find("typing-mistake.json:1: /titel: expected no member of this name"),
              std::string::npos)
        << ran.errors;
}

TEST_F(LabVerbs, RefuseOptionsThatNothingFits) {
    for (const char* line :
         {"selftest --exercise tick1 --screenshots", "selftest --exercise tick1 --hostile",
          "coverage --only no-such-case"}) {
        const Ran ran = runLab(line);
        EXPECT_EQ(ran.status, 2) << line << "\n" << ran.output << ran.errors;
    }
    folder_.write("tables.md",
                  "<!-- public_coverage begin -->\nold\n<!-- public_coverage end -->\n");
    const std::string file = (folder_.path() / "tables.md").string();
    EXPECT_EQ(runLab("coverage --only no-such-case --write '" + file + "'").status, 2);
    EXPECT_NE(tests::readFile(file).find("\nold\n"), std::string::npos);
}

TEST_F(LabVerbs, SelftestTakesAtLeastOneScreenshotOfEachKind) {
    const Ran ran = runLab("selftest --screenshots --fraction 0.0005");
    EXPECT_EQ(ran.status, 0) << ran.output << ran.errors;
    const std::size_t first = ran.output.find("1 of   1");
    ASSERT_NE(first, std::string::npos) << ran.output;
    EXPECT_NE(ran.output.find("1 of   1", first + 1), std::string::npos) << ran.output;
}

// docs/for-instructors.md: copy a scene, add a line, call refs.
TEST_F(LabVerbs, RefsMakesTheReferenceOfANewSceneThatIsListed) {
    fs::copy(home() / "scenes/relief.xml", home() / "scenes/mine.xml");
    folder_.write(
        "home/scenes/references.json",
        R"({"references": [{"scene": "mine", "pinhole": true, "width": 32, "height": 24}]})");
    const std::string out = (folder_.path() / "references").string();
    const Ran made = run("refs --folder '" + out + "'");
    EXPECT_EQ(made.status, 0) << made.errors;
    EXPECT_TRUE(fs::exists(out + "/mine.png"));
    EXPECT_NE(made.errors.find("relief.xml has no reference: "), std::string::npos) << made.errors;
    EXPECT_EQ(run("refs --check --folder '" + out + "'").status, 0);
}

TEST_F(LabVerbs, RefsNamesTheEntryThatCannotBeRead) {
    for (const std::string entry :
         {R"({"scene": "relief", "pinhole": true, "width": 32})",
          R"({"scene": "relief", "pinhole": true, "width": 32, "height": 9999})",
          R"({"scene": "relief", "pinhole": true, "width": 32, "height": 24, "seed": 1})"}) {
        folder_.write("home/scenes/references.json", R"({"references": [)" + entry + "]}");
        const Ran ran = run("refs --folder '" + (folder_.path() / "references").string() + "'");
        EXPECT_EQ(ran.status, 2) << entry;
        EXPECT_NE(ran.errors.find("references.json: \"references\"[0]"), std::string::npos)
            << ran.errors;
    }
}

TEST_F(LabVerbs, RefsTakesTheScenesOfOneExercise) {
    folder_.write("home/scenes/references.json", R"({"references": [
        {"scene": "main-basic", "pinhole": true, "width": 32, "height": 24},
        {"scene": "bump-mapping", "pinhole": true, "width": 32, "height": 24}]})");
    const std::string out = (folder_.path() / "references").string();
    EXPECT_EQ(run("refs --exercise tick1star --folder '" + out + "'").status, 0);
    EXPECT_FALSE(fs::exists(out + "/main-basic.png"));
    EXPECT_TRUE(fs::exists(out + "/bump-mapping.png"));
    EXPECT_EQ(run("refs --exercise tick1 --folder '" + out + "'").status, 0);
    EXPECT_TRUE(fs::exists(out + "/main-basic.png"));
    EXPECT_EQ(run("refs --check --exercise tick1 --folder '" + out + "'").status, 0);
}

TEST_F(LabVerbs, RefsListsEveryScene) {
    const std::string listed = tests::readFile("scenes/references.json");
    for (const fs::directory_entry& scene : fs::directory_iterator{home() / "scenes"}) {
        const std::string name = scene.path().stem();
        if (scene.path().extension() != ".xml") continue;
        EXPECT_NE(listed.find("{\"scene\": \"" + name + "\""), std::string::npos) << name;
        EXPECT_TRUE(fs::exists(home() / "assets/references" / (name + "-mean.tiff"))) << name;
    }
}

TEST_F(LabVerbs, PackageMakesTheFolderOfItsFile) {
    const fs::path file = folder_.path() / "new/folder/kit.zip";
    const Ran ran = run("package student -o '" + file.string() + "'");
    EXPECT_EQ(ran.status, 0) << ran.errors;
    EXPECT_TRUE(fs::exists(file));
}

TEST_F(LabVerbs, PackageSaysWhichFolderCannotBeMade) {
    folder_.write("file", "");
    const std::string folder = (folder_.path() / "file/below").string();
    const Ran ran = run("package student -o '" + folder + "/kit.zip'");
    EXPECT_EQ(ran.status, 2);
    EXPECT_NE(ran.errors.find(folder + ": cannot be made"), std::string::npos) << ran.errors;
}

TEST_F(LabVerbs, TickerSaysWhereTheLabsVerbsAre) {
    const Ran ran = run("selftest --task T1");
    EXPECT_EQ(ran.status, 2);
    EXPECT_NE(ran.errors.find("selftest: is in ticker-lab: ./tick selftest"), std::string::npos)
        << ran.errors;
}

TEST_F(LabVerbs, CalibrateSaysThatItNeedsACheckout) {
    const Ran ran = runLab("calibrate --check");
    EXPECT_EQ(ran.status, 2);
    EXPECT_NE(ran.errors.find("works in the project's checkout only"), std::string::npos)
        << ran.errors;
}

}  // namespace
}  // namespace ticker::cli
