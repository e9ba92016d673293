#include <grader/corpus/Entry.h>
#include <grader/tests/support/Files.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <archive.h>
#include <archive_entry.h>

#include <memory>
#include <set>

namespace ticker::corpus {
namespace {

namespace fs = std::filesystem;

using tests::TemporaryFolder;

std::vector<Entry> hostileEntries() {
    return readEntries(TICKER_SOURCE_DIR, {"hostile"});
}

Entry find(const std::string& name) {
    for (const Entry& each : hostileEntries())
        if (each.name == name) return each;
    ADD_FAILURE() << "no case " << name;
    return {};
}

TEST(HostileCorpus, HoldsAtLeastSeventySubmissions) {
    EXPECT_GE(hostileEntries().size(), 70U);
}

// The contract's finding ids have a part before and a part after the point.
TEST(HostileCorpus, NamesTasksAndFindingsAsTheContractDoes) {
    const std::set<std::string> parts{"bump",  "shadow", "dof",    "screenshot",
                                      "build", "run",    "intake", "settings"};
    for (const Entry& each : hostileEntries()) {
        EXPECT_EQ(each.tasks.size(), 1U) << each.name;
        EXPECT_TRUE(each.task() == "T1" || each.task() == "T2.1" || each.task() == "T2.2")
            << each.name;
        for (const std::string& finding :
             each.expected().findings.value_or(std::vector<std::string>{}))
            EXPECT_TRUE(parts.count(finding.substr(0, finding.find('.'))) == 1)
                << each.name << ": " << finding;
    }
}

TEST(HostileCorpus, NeverAwardsTheTick) {
    for (const Entry& each : hostileEntries()) {
        EXPECT_FALSE(each.verdicts.empty()) << each.name;
        for (const std::string& verdict : each.verdicts)
            EXPECT_NE(verdict, "awarded") << each.name;
    }
}

// A blocked or failed task without a finding tells its student nothing.
TEST(HostileCorpus, ExpectsAFindingWhereverATaskCannotPass) {
    for (const Entry& each : hostileEntries()) {
        const std::string& state = each.expected().states.front();
        EXPECT_TRUE(state == "passed" || state == "notAttempted" ||
                    !each.expected().finding().empty())
            << each.name;
    }
}

TEST(HostileCorpus, GivesEverySubmissionAFolderOfItsOwnInTheClass) {
    std::set<std::string> names;
    for (const Entry& each : hostileEntries())
        EXPECT_TRUE(names.insert(each.folderName).second) << each.name;
    EXPECT_EQ(find("named-in-capitals").folderName, "SUMMARY.CSV");
    EXPECT_EQ(find("empty-source").folderName, "empty-source");
}

TEST(WriteSubmission, LaysOutEveryCase) {
    for (const Entry& each : hostileEntries()) {
        const TemporaryFolder folder;
        EXPECT_NO_THROW(writeSubmission(each, "/nowhere/secret", folder.path())) << each.name;
        EXPECT_FALSE(fs::is_empty(folder.path())) << each.name;
        EXPECT_FALSE(fs::exists(folder.path() / "expected.json")) << each.name;
    }
}

TEST(WriteSubmission, AimsAtTheSecret) {
    const TemporaryFolder folder;
    writeSubmission(find("include-secret"), "/planted/secret.h", folder.path());
    const std::string text = tests::readFile(folder.path() / "BumpySphere.cpp");
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
    folder.write("grader/corpus/hostile/cases/case/expected.json", expected);
    try {
        static_cast<void>(readEntries(folder.path(), {"hostile"}));
    } catch (const raytracer::InputError& error) {
        const std::string text = error.what();
        return text.substr(text.find("expected.json"));
    }
    return "none";
}

TEST(ReadEntries, NamesTheMemberThatIsWrong) {
    EXPECT_TRUE(complaint("no").starts_with("expected.json:1: not JSON"));
    EXPECT_EQ(complaint("{}"),
              "expected.json:1: the file: expected an object with a member \"about\"");
    EXPECT_EQ(complaint(R"({"about": "x", "expect": {"T1": {"state": ["great"]}}})"),
              "expected.json:1: /expect/T1/state: \"great\" is not known");
    EXPECT_EQ(complaint(R"({"about": "x", "expect": {"T1": {"state": "passed"}}, "colour": 1})"),
              "expected.json:1: /colour: expected no member of this name; known are: about, alone, "
              "folder, base, edits, make, expect");
    EXPECT_EQ(
        complaint(R"({"about": "x", "edits": {"a": []}, "expect": {"T1": {"state": "passed"}}})"),
        "expected.json:1: the file: has edits of no \"base\"");
}

}  // namespace
}  // namespace ticker::corpus
