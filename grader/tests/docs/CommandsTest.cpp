// Runs every command of a document as written, from top to bottom, in a checkout of its own: links
// to this one, with its own out/ and home. It has fewer samples and fewer reference pictures: all
// samples are graded by test_pipeline, all references are compared by `./tick guard slow`.
#include <grader/tests/support/Files.h>
#include <grader/tests/support/MoodleExport.h>
#include <grader/tests/support/RunCommand.h>
#include <grader/tests/support/ShellBlocks.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>
#include <string>
#include <vector>

namespace ticker {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = TICKER_SOURCE_DIR;

const std::vector<std::string> kHere{"README.md", "CONTRIBUTING.md", "docs/for-instructors.md",
                                     "docs/for-tickers.md", "docs/platforms.md"};
// Their commands are for students: the test of the student's package runs them.
const std::set<std::string> kInThePackage{"student_template/README.md", "docs/handout.md",
                                          "docs/for-students.md", "docs/handout-tick1.md",
                                          "student_template/tick1/README.md"};

// Samples for each verdict; documents name some of them.
const std::vector<std::string> kSamples{
    "awarded/bump-bilinear",         "awarded/reference-bump",
    "awarded/reference-distributed", "notAwarded/bump-inverted-u",
    "notAwarded/does-not-compile",   "notAwarded/distributed-off-centre",
    "notAwarded/template-untouched", "needsReview/two-versions"};
const std::string kReferences = R"({"references": [
    {"scene": "bumpmap-test", "pinhole": true, "width": 320, "height": 240},
    {"scene": "lens-grid", "pinhole": false, "width": 96, "height": 72}]})";

/// A folder in which a document's commands may write.
class Checkout {
public:
    Checkout() {
        link("", {"build", "out", "grader", "scenes"});
        link("grader", {"corpus"});
        link("grader/corpus", {"samples"});
        for (const std::string& sample : kSamples) {
            const fs::path folder = fs::path{"grader/corpus/samples"} / sample;
            fs::create_directories(path() / folder);
            fs::copy(kRoot / folder, path() / folder, fs::copy_options::recursive);
        }
        link("scenes", {"references.json"});
        work_.write("scenes/references.json", kReferences);
        fs::create_directories(path() / "out");
        fs::create_directories(path() / "build");
        fs::create_directory_symlink(TICKER_BINARY_DIR, path() / "build/release");
        putClass();
    }

    [[nodiscard]] fs::path path() const { return work_.path(); }

    [[nodiscard]] tests::CommandResult run(const std::string& script) const {
        work_.write("commands.sh", script);
        const std::string here = "'" + path().string() + "'";
        return tests::runCommand("cd " + here + " && HOME=" + here + " TICKER_HOME=" + here +
                                 " bash commands.sh </dev/null");
    }

private:
    /// Links to what a folder of the project has, without some names and Git's own.
    void link(const fs::path& folder, const std::set<std::string>& without) const {
        fs::create_directories(path() / folder);
        for (const fs::directory_entry& entry : fs::directory_iterator{kRoot / folder}) {
            const std::string name = entry.path().filename();
            if (!without.contains(name) && !name.starts_with(".git"))
                fs::create_symlink(entry.path(), path() / folder / name);
        }
    }

    /// The class that a ticker downloads from Moodle.
    void putClass() const {
        std::vector<tests::MoodleStudent> students;
        int id = 100;
        for (const char* sample : {"awarded/reference-bump", "notAwarded/bump-inverted-u"}) {
            const std::string folder = "grader/corpus/samples/" + std::string{sample} + "/";
            tests::MoodleStudent student{"Ann Lee " + std::to_string(id), id};
            for (const char* name : {"BumpySphere.cpp", "screenshot.png"})
                if (fs::exists(kRoot / (folder + name)))
                    student.files.push_back({name, tests::readFile(folder + name)});
            students.push_back(student);
            ++id;
        }
        fs::create_directories(path() / "Downloads");
        tests::writeZip(path() / "Downloads/CS-Tick1-4711.zip", tests::moodleExport(students));
    }

    tests::TemporaryFolder work_;
};

std::string testName(const ::testing::TestParamInfo<std::string>& info) {
    std::string name;
    for (const char c : fs::path{info.param}.stem().string())
        if (c != '-') name += c;
    return name;
}

class Commands : public ::testing::TestWithParam<std::string> {};

TEST_P(Commands, WorkAsTheyAreWritten) {
    const std::vector<tests::ShellBlock> blocks = tests::shellBlocks(GetParam());
    ASSERT_FALSE(blocks.empty());
    const Checkout checkout;

    const tests::CommandResult ran = checkout.run(tests::scriptOf(blocks));

    EXPECT_EQ(ran.status, 0) << ran.output;
    std::cout << tests::skippedIn(blocks);
}

INSTANTIATE_TEST_SUITE_P(Of, Commands, ::testing::ValuesIn(kHere), testName);

TEST(Documents, AreAllRunSomewhere) {
    const std::set<std::string> here{kHere.begin(), kHere.end()};
    int run = 0;
    int skipped = 0;
    for (const fs::path& file : tests::documents()) {
        const std::string name = file.lexically_relative(kRoot);
        const std::vector<tests::ShellBlock> blocks = tests::shellBlocks(name);
        const bool hasCommands = std::ranges::any_of(
            blocks, [](const tests::ShellBlock& block) { return block.skip.empty(); });
        EXPECT_EQ(hasCommands, here.contains(name) || kInThePackage.contains(name)) << name;
        for (const tests::ShellBlock& block : blocks)
            (block.skip.empty() ? run : skipped) += block.count();
        std::cout << tests::skippedIn(blocks);
    }
    std::cout << run << " commands are run, " << skipped << " are not\n";
    EXPECT_GT(run, skipped);
}

}  // namespace
}  // namespace ticker
