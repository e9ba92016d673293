#include <grader/base/WholeFile.h>
#include <grader/exercise/Exercise.h>
#include <grader/lab/calibrate/Parts.h>
#include <grader/lab/calibrate/RunCampaign.h>
#include <grader/lab/calibrate/Staleness.h>
#include <grader/tests/calibrate/CountingCampaign.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ticker::calibrate {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = TICKER_SOURCE_DIR;
const std::regex kBound{"(constexpr double k[A-Za-z]+ =) "};

std::vector<std::string> everyTask() {
    std::vector<std::string> ids;
    for (const Exercise& exercise : knownExercises())
        for (const TaskEntry& task : exercise.tasks)
            ids.push_back(task.id);
    return ids;
}

/// All tasks, and what else has a row in parts.json.
std::vector<std::string> everythingMeasured() {
    std::vector<std::string> measured = everyTask();
    measured.insert(measured.end(), {"pictures", "methods", "agreement"});
    return measured;
}

/// The measured sources in a folder of their own, with a record of each task for this code.
class CopiedSources : public testing::Test {
protected:
    CopiedSources() {
        campaign_.measured = everyTask();
        copy("grader/lab/calibrate/parts.json");
        fs::create_directories(root() / "grader/exercises");  // there even if no exercise has code
        const Parts all{kSource};
        for (const std::string& measured : everythingMeasured())
            for (const fs::path& file : all.filesOf(measured))
                copy(file);
        campaign_.text = "an entry";
        const std::vector<Stamp> stamps = stampsOf(campaign_, Parts{root()});
        for (std::size_t unit = 0; unit < stamps.size(); ++unit)
            record_.add(unit, R"({"cpu":90000})", stamps[unit]);
    }

    [[nodiscard]] const fs::path& root() const { return sources_.path(); }

    [[nodiscard]] fs::path firstWithABound(const char* folder) const {
        for (const auto& entry : fs::recursive_directory_iterator(root() / folder))
            if (entry.is_regular_file() && std::regex_search(readWhole(entry.path()), kBound))
                return entry.path();
        return {};
    }
    [[nodiscard]] std::vector<std::string> stale() const {
        const Parts parts{root()};
        return stalenessOf(campaign_, record_, stampsOf(campaign_, parts), parts);
    }

    CountingCampaign campaign_{everyTask().size()};

private:
    void copy(const fs::path& file) const {
        fs::create_directories((root() / file).parent_path());
        fs::copy_file(kSource / file, root() / file, fs::copy_options::overwrite_existing);
    }

    tests::TemporaryFolder sources_;
    tests::TemporaryFolder records_;
    Record record_{records_.path(), campaign_};
};

TEST_F(CopiedSources, MatchTheirRecordWhileNothingHasChanged) {
    EXPECT_EQ(stale(), std::vector<std::string>{});
}

struct TaskFolder {
    const char* folder;
    const char* tasks;
};

TEST_F(CopiedSources, OfWhichABoundHasChangedAreNamedWithTheirTasks) {
    constexpr TaskFolder kFolders[] = {{"grader/tasks/bump", "T1"},
                                       {"grader/tasks/shadows", "T2.1"},
                                       {"grader/tasks/lens", "T2.2"},
                                       {"grader/tasks/maintick", "M1, M2, M3.1, M3.2, M4"}};
    for (const TaskFolder& task : kFolders) {
        const fs::path file = firstWithABound(task.folder);
        const std::string before = readWhole(file);
        std::ofstream{file} << std::regex_replace(before, kBound, "$1 2.0 * ",
                                                  std::regex_constants::format_first_only);
        const std::vector<std::string> lines = stale();
        ASSERT_EQ(lines.size(), 1U) << file;
        for (const std::string& part :
             {std::string{" units of "} + task.tasks + " are of other code",
              std::string{"changed: "} + task.folder,
              std::string{"./tick calibrate --only counting"}})
            EXPECT_NE(lines[0].find(part), std::string::npos) << lines[0];
        std::ofstream{file} << before;
    }
}

TEST_F(CopiedSources, KeepTheirRecordWhenWordsChange) {
    const fs::path file = root() / "grader/tasks/shadows/ShadowFindings.h";
    const std::string before = readWhole(file);
    const std::regex words{"\"([A-Z][a-z]+) "};
    ASSERT_TRUE(std::regex_search(before, words));
    std::ofstream{file} << "// A remark.\n" << std::regex_replace(before, words, "\"Often, $1 ");
    EXPECT_EQ(stale(), std::vector<std::string>{});
}

TEST_F(CopiedSources, TellWhichEntryChangedAndHowLongItTakes) {
    campaign_.text = "another text of every entry";
    const std::vector<std::string> lines = stale();
    ASSERT_EQ(lines.size(), 1U);
    const std::size_t units = campaign_.units();
    for (const std::string& part :
         {std::string{"the entry itself"}, std::string{"(entry 0, entry 1,"},
          fmt::format("and {} more", units - 5),
          fmt::format("{:.1f} minutes", 1.5 * static_cast<double>(units))})
        EXPECT_NE(lines[0].find(part), std::string::npos) << lines[0];
}

TEST_F(CopiedSources, RefuseATableWithAPathThatIsGone) {
    fs::remove_all(root() / "grader/tasks/lens");
    EXPECT_THROW(Parts{root()}, raytracer::InputError);
}

TEST_F(CopiedSources, OfATaskWithoutARowAreThoseOfTheRowForAnyOtherTask) {
    const fs::path table = root() / "grader/lab/calibrate/parts.json";
    const std::regex rows{R"re( *"(shadows|T2\.1)": \[[^\]]*\],\n)re"};
    const std::string text = std::regex_replace(readWhole(table), rows, "");
    std::ofstream{table} << text;
    fs::create_directories(root() / "grader/tasks/screenshot");
    std::ofstream{root() / "grader/tasks/screenshot/Whole.h"} << "int a;\n";
    fs::create_directories(root() / "grader/exercises/tick1star");
    std::ofstream{root() / "grader/exercises/tick1star/Calls.cpp"} << "int b;\n";

    const Parts parts{root()};
    const std::vector<fs::path> files = parts.filesOf("T2.1");
    const auto has = [&](const char* file) { return std::ranges::count(files, file) == 1; };
    EXPECT_TRUE(has("grader/tasks/shadows/JudgeShadows.cpp"));
    EXPECT_TRUE(has("grader/tasks/support/Draw.cpp"));
    EXPECT_TRUE(has("grader/probe/Wire.cpp"));
    EXPECT_TRUE(has("grader/exercises/tick1star/Calls.cpp"));
    EXPECT_FALSE(has("grader/tasks/lens/JudgeLens.cpp"));
    EXPECT_FALSE(has("grader/tasks/screenshot/Whole.h"));
    EXPECT_THROW(static_cast<void>(parts.stampOf("T9")), raytracer::InputError);
}

/// Path of an included header from the project's root; empty for one of a package.
fs::path includedFile(const std::string& name) {
    if (name.starts_with("grader/")) return name;
    if (name.starts_with("raytracer/")) return "student_template/framework/include/" + name;
    if (name.starts_with("questions/")) return "student_template/tests/" + name;
    return {};
}

// Files that parts.json may omit: structs, texts and readers, on which no verdict depends.
bool isLeftOut(const fs::path& file) {
    const std::string folder = file.parent_path().generic_string();
    return folder == "grader/result" || folder == "grader/exercise" || folder == "grader/picture" ||
           folder.ends_with("raytracer/io") || folder == "grader/oracle/references" ||
           file.filename() == "BumpPicture.h" || file.filename() == "ShadowFindings.h";
}

TEST(Parts, NameAllThatTheirFilesInclude) {
    const Parts parts{kSource};
    const std::regex line{"#include <([^>]+)>"};
    for (const std::string& measured : everythingMeasured()) {
        const std::vector<fs::path> files = parts.filesOf(measured);
        const std::set<fs::path> known{files.begin(), files.end()};
        for (const fs::path& file : files) {
            const std::string text = readWhole(kSource / file);
            for (std::sregex_iterator at{text.begin(), text.end(), line}, end; at != end; ++at) {
                const fs::path included = includedFile((*at)[1]);
                EXPECT_TRUE(included.empty() || known.contains(included) || isLeftOut(included))
                    << measured << ": " << file << " includes " << included
                    << ", which parts.json does not have";
            }
        }
    }
}

TEST(Parts, KnowEveryTask) {
    const Parts parts{kSource};
    for (const std::string& task : everyTask())
        EXPECT_FALSE(parts.stampOf(task).empty());
}

}  // namespace
}  // namespace ticker::calibrate
