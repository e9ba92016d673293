#include <grader/corpus/Catalogue.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace ticker::mistakes {
namespace {

namespace fs = std::filesystem;

std::string readText(const fs::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// A catalogue of one file, in a folder of its own.
class OneMistake {
public:
    explicit OneMistake(const std::string& text, const std::string& id = "example")
        : folder_(fs::path(testing::TempDir()) /
                  testing::UnitTest::GetInstance()->current_test_info()->name()) {
        fs::create_directories(folder_ / "mistakes" / "T1");
        std::ofstream(folder_ / "mistakes" / "T1" / (id + ".json")) << text;
    }
    ~OneMistake() { fs::remove_all(folder_); }
    OneMistake(const OneMistake&) = delete;
    OneMistake& operator=(const OneMistake&) = delete;

    [[nodiscard]] std::vector<Mistake> read() const { return readCatalogue(folder_); }
    /// What the reader complains about; empty where it does not.
    [[nodiscard]] std::string complaint() const {
        try {
            (void)read();
            return {};
        } catch (const raytracer::InputError& error) {
            return error.what();
        }
    }

private:
    fs::path folder_;
};

constexpr const char* kExample = R"({"id": "example", "task": "T1", "file": "BumpySphere.cpp",
  "title": "t", "edits": [{"find": ["one", "two"], "replace": "three"}],
  "expect": {"state": "blocked", "finding": "run.crashed"}})";

std::string exampleWith(const std::string& find, const std::string& replace) {
    std::string text = kExample;
    return text.replace(text.find(find), find.size(), replace);
}

TEST(Catalogue, EveryMistakeFitsTheReferenceAndChangesIt) {
    const fs::path root = TICKER_SOURCE_DIR;
    std::set<std::string> ids;
    for (const Mistake& mistake : readCatalogue(root / "grader" / "corpus")) {
        SCOPED_TRACE(mistake.path);
        const std::string reference =
            readText(root / "reference_solution" / "exercise" / mistake.file);
        ASSERT_FALSE(reference.empty()) << "there is no such file";
        EXPECT_NE(makeMistake(mistake, reference), reference);
        EXPECT_TRUE(ids.insert(mistake.task + "/" + mistake.id).second);
    }
    EXPECT_GT(ids.size(), 0U);
}

TEST(Catalogue, JoinsLinesAndReadsTheExpectation) {
    const auto mistakes = OneMistake(kExample).read();
    ASSERT_EQ(mistakes.size(), 1U);
    EXPECT_EQ(mistakes[0].edits.at(0).find, "one\ntwo");
    EXPECT_EQ(mistakes[0].expect.state, TaskState::blocked);
    EXPECT_EQ(mistakes[0].expect.finding, "run.crashed");
    EXPECT_FALSE(mistakes[0].expect.needsReview);
    EXPECT_EQ(makeMistake(mistakes[0], "zero one\ntwo four"), "zero three four");
}

TEST(Catalogue, ReadsThatAPersonHasToLook) {
    const OneMistake read{exampleWith("run.crashed\"", "run.crashed\", \"needsReview\": true")};
    EXPECT_TRUE(read.read().at(0).expect.needsReview);
}

TEST(Catalogue, RefusesAPersonWhoIsNeitherAskedNorNot) {
    const OneMistake odd{exampleWith("run.crashed\"", "run.crashed\", \"needsReview\": 1")};
    EXPECT_NE(odd.complaint().find("\"needsReview\" must be true or false"), std::string::npos);
}

TEST(Catalogue, RefusesAnEditThatDoesNotFitOnce) {
    const auto mistakes = OneMistake(kExample).read();
    EXPECT_THROW((void)makeMistake(mistakes[0], "one two"), raytracer::InputError);
    EXPECT_THROW((void)makeMistake(mistakes[0], "one\ntwo one\ntwo"), raytracer::InputError);
}

TEST(Catalogue, NamesTheLineWhereTheTextIsNoJson) {
    EXPECT_NE(OneMistake("{\n\"id\": ,\n}").complaint().find("example.json:2: "),
              std::string::npos);
}

TEST(Catalogue, RefusesAnUnknownMember) {
    EXPECT_NE(OneMistake(exampleWith("\"title\"", "\"titel\": 1, \"title\""))
                  .complaint()
                  .find("does not know \"titel\""),
              std::string::npos);
}

TEST(Catalogue, RefusesAMissingMember) {
    EXPECT_NE(OneMistake(exampleWith("\"title\": \"t\",", "")).complaint().find("needs \"title\""),
              std::string::npos);
}

TEST(Catalogue, RefusesAnUnknownState) {
    EXPECT_NE(OneMistake(exampleWith("blocked", "bocked")).complaint().find("unknown state"),
              std::string::npos);
}

TEST(Catalogue, RefusesANameThatIsNotTheFiles) {
    EXPECT_NE(OneMistake(kExample, "other").complaint().find("file's name"), std::string::npos);
    EXPECT_NE(OneMistake(exampleWith("\"T1\"", "\"T2.1\"")).complaint().find("folder's name"),
              std::string::npos);
}

}  // namespace
}  // namespace ticker::mistakes
