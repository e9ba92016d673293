#include <grader/corpus/HostileCase.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <archive.h>
#include <archive_entry.h>
#include <unistd.h>

#include <fstream>
#include <memory>
#include <set>
#include <sstream>

namespace ticker::hostile {
namespace {

namespace fs = std::filesystem;

const fs::path kCases = fs::path{TICKER_SOURCE_DIR} / "grader/corpus/hostile/cases";

class TemporaryFolder {
public:
    TemporaryFolder() {
        std::string name = (fs::temp_directory_path() / "ticker-test-XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) throw raytracer::Error("mkdtemp");
        path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

std::string readAll(const fs::path& file) {
    std::ifstream stream{file, std::ios::binary};
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

HostileCase find(const std::string& name) {
    for (const HostileCase& each : listHostileCases(kCases))
        if (each.name == name) return each;
    ADD_FAILURE() << "no case " << name;
    return {};
}

TEST(HostileCorpus, HoldsAtLeastSeventySubmissions) {
    EXPECT_GE(listHostileCases(kCases).size(), 70U);
}

// The contract's finding ids have a part before and one after the point.
TEST(HostileCorpus, NamesTasksAndFindingsAsTheContractDoes) {
    const std::set<std::string> parts{"bump",  "shadow", "dof",    "screenshot",
                                      "build", "run",    "intake", "settings"};
    for (const HostileCase& each : listHostileCases(kCases)) {
        EXPECT_TRUE(each.task == "T1" || each.task == "T2.1" || each.task == "T2.2") << each.name;
        for (const std::string& finding : each.findings)
            EXPECT_TRUE(parts.count(finding.substr(0, finding.find('.'))) == 1)
                << each.name << ": " << finding;
    }
}

TEST(HostileCorpus, NeverAwardsTheTick) {
    for (const HostileCase& each : listHostileCases(kCases))
        for (const std::string& verdict : each.verdicts)
            EXPECT_NE(verdict, "awarded") << each.name;
}

// A blocked or failed task without a finding tells its student nothing.
TEST(HostileCorpus, ExpectsAFindingWhereverATaskCannotPass) {
    for (const HostileCase& each : listHostileCases(kCases)) {
        const std::string& state = each.states.front();
        EXPECT_TRUE(state == "passed" || state == "notAttempted" || !each.findings.empty())
            << each.name;
    }
}

TEST(HostileCorpus, GivesEverySubmissionAFolderOfItsOwnInTheClass) {
    std::set<std::string> names;
    for (const HostileCase& each : listHostileCases(kCases))
        EXPECT_TRUE(names.insert(each.handedInAs).second) << each.name;
    EXPECT_EQ(find("named-in-capitals").handedInAs, "SUMMARY.CSV");
    EXPECT_EQ(find("empty-source").handedInAs, "empty-source");
}

TEST(WriteSubmission, LaysOutEveryCase) {
    for (const HostileCase& each : listHostileCases(kCases)) {
        const TemporaryFolder folder;
        EXPECT_NO_THROW(writeSubmission(each, "/nowhere/secret", folder.path())) << each.name;
        EXPECT_FALSE(fs::is_empty(folder.path())) << each.name;
        EXPECT_FALSE(fs::exists(folder.path() / "expected.json")) << each.name;
    }
}

TEST(WriteSubmission, AimsAtTheSecret) {
    const TemporaryFolder folder;
    writeSubmission(find("include-secret"), "/planted/secret.h", folder.path());
    const std::string text = readAll(folder.path() / "BumpySphere.cpp");
    EXPECT_NE(text.find("#include \"/planted/secret.h\""), std::string::npos);
    EXPECT_EQ(text.find("@SECRET@"), std::string::npos);
}

TEST(WriteSubmission, MakesLinksAndPipes) {
    const TemporaryFolder folder;
    writeSubmission(find("screenshot-link"), "/planted/secret", folder.path());
    EXPECT_EQ(fs::read_symlink(folder.path() / "screenshot.png"), "/planted/secret");
    const TemporaryFolder other;
    writeSubmission(find("screenshot-pipe"), "/planted/secret", other.path());
    EXPECT_TRUE(fs::is_fifo(other.path() / "screenshot.png"));
}

std::vector<std::string> membersOf(const fs::path& file) {
    std::vector<std::string> names;
    const std::unique_ptr<archive, decltype(&archive_read_free)> reader{archive_read_new(),
                                                                        archive_read_free};
    archive_read_support_format_all(reader.get());
    EXPECT_EQ(archive_read_open_filename(reader.get(), file.c_str(), 65536), ARCHIVE_OK);
    archive_entry* entry = nullptr;
    while (archive_read_next_header(reader.get(), &entry) == ARCHIVE_OK)
        names.emplace_back(archive_entry_pathname(entry));
    return names;
}

TEST(WriteSubmission, WritesArchivesThatEscape) {
    const TemporaryFolder folder;
    writeSubmission(find("archive-escape"), "/planted/secret", folder.path());
    EXPECT_EQ(membersOf(folder.path() / "submission.zip"),
              (std::vector<std::string>{"BumpySphere.cpp", "../../../../tmp/ticker-escaped"}));
}

TEST(WriteSubmission, WritesBombsThatAreSmall) {
    const TemporaryFolder folder;
    writeSubmission(find("archive-bomb"), "/planted/secret", folder.path());
    EXPECT_LT(fs::file_size(folder.path() / "submission.zip"), 1U << 20U);
}

std::string complaint(const std::string& expected) {
    const TemporaryFolder folder;
    fs::create_directory(folder.path() / "case");
    std::ofstream{folder.path() / "case/expected.json"} << expected;
    try {
        static_cast<void>(listHostileCases(folder.path()));
    } catch (const raytracer::InputError& error) {
        const std::string text = error.what();
        return text.substr(text.find("expected.json"));
    }
    return "none";
}

TEST(ListHostileCases, NamesTheFieldThatIsWrong) {
    EXPECT_EQ(complaint("no"), "expected.json: is missing, or not JSON");
    EXPECT_EQ(complaint("{}"), "expected.json: about: is missing");
    EXPECT_EQ(complaint(R"({"about": "x", "task": "T1", "states": ["great"], "findings": [],
                            "verdicts": ["awarded"]})"),
              "expected.json: states: does not know \"great\"");
    EXPECT_EQ(complaint(R"({"colour": 1})"), "expected.json: colour: is not known");
}

}  // namespace
}  // namespace ticker::hostile
