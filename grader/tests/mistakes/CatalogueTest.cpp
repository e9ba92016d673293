#include <grader/corpus/Entry.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace ticker::corpus {
namespace {

/// A project with a corpus of one mistake.
class OneMistake {
public:
    explicit OneMistake(const std::string& text, const std::string& reference = "one\ntwo") {
        folder_.write("reference_solution/exercise/BumpySphere.cpp", reference);
        folder_.write("grader/corpus/mistakes/T1/example.json", text);
    }

    [[nodiscard]] std::vector<Entry> read() const { return readCatalogue(folder_.path()); }
    [[nodiscard]] std::string made() const { return textsOf(read().at(0)).at("BumpySphere.cpp"); }
    /// The reader's error message; empty without an error.
    [[nodiscard]] std::string complaint() const {
        try {
            (void)read();
            return {};
        } catch (const raytracer::InputError& error) {
            return error.what();
        }
    }

private:
    tests::TemporaryFolder folder_;
};

constexpr const char* kExample = R"({"about": "t", "base": "reference",
  "edits": {"BumpySphere.cpp": [{"find": ["one", "two"], "replace": "three"}]},
  "expect": {"T1": {"state": "blocked", "findings": ["run.crashed"]}}})";

std::string exampleWith(const std::string& find, const std::string& replace) {
    std::string text = kExample;
    return text.replace(text.find(find), find.size(), replace);
}

TEST(Catalogue, EveryMistakeFitsTheReferenceAndChangesIt) {
    std::set<std::string> ids;
    for (Entry& mistake : readCatalogue(TICKER_SOURCE_DIR)) {
        SCOPED_TRACE(mistake.path);
        const auto changed = textsOf(mistake);
        ASSERT_EQ(changed.size(), 1U);
        mistake.edits.begin()->second.clear();
        EXPECT_NE(changed, textsOf(mistake));
        ASSERT_EQ(mistake.tasks.size(), 1U);
        EXPECT_EQ(mistake.tasks.begin()->first, mistake.group);
        EXPECT_TRUE(ids.insert(mistake.group + "/" + mistake.name).second);
    }
    EXPECT_GT(ids.size(), 0U);
}

TEST(Catalogue, JoinsLinesAndReadsTheExpectation) {
    const OneMistake one{kExample, "zero one\ntwo four"};
    const Entry entry = one.read().at(0);
    EXPECT_EQ(entry.name, "example");
    EXPECT_EQ(entry.task(), "T1");
    EXPECT_EQ(entry.edits.at("BumpySphere.cpp").at(0).find, "one\ntwo");
    EXPECT_TRUE(entry.expected().isMet("blocked", "run.crashed"));
    EXPECT_FALSE(entry.expected().isMet("blocked", ""));
    EXPECT_FALSE(entry.expected().isMet("failed", "run.crashed"));
    EXPECT_FALSE(entry.expected().needsReview);
    EXPECT_EQ(one.made(), "zero three four");
}

TEST(Catalogue, ReadsThatAPersonHasToLook) {
    const OneMistake read{exampleWith("run.crashed\"]", "run.crashed\"], \"needsReview\": true")};
    EXPECT_TRUE(read.read().at(0).expected().needsReview);
}

TEST(Catalogue, RefusesAPersonWhoIsNeitherAskedNorNot) {
    const OneMistake odd{exampleWith("run.crashed\"]", "run.crashed\"], \"needsReview\": 1")};
    EXPECT_NE(odd.complaint().find("/expect/T1/needsReview: expected true or false"),
              std::string::npos);
}

TEST(Catalogue, RefusesAnEditThatDoesNotFitOnce) {
    EXPECT_THROW((void)OneMistake(kExample, "one two").made(), raytracer::InputError);
    EXPECT_THROW((void)OneMistake(kExample, "one\ntwo one\ntwo").made(), raytracer::InputError);
}

TEST(Catalogue, NamesTheLineWhereTheTextIsNoJson) {
    EXPECT_NE(OneMistake("{\n\"about\": ,\n}").complaint().find("example.json:2: "),
              std::string::npos);
}

TEST(Catalogue, RefusesAnUnknownMember) {
    EXPECT_NE(OneMistake(exampleWith("\"about\"", "\"abuot\": 1, \"about\""))
                  .complaint()
                  .find("/abuot: expected no member of this name"),
              std::string::npos);
}

TEST(Catalogue, RefusesAMissingMember) {
    EXPECT_NE(OneMistake(exampleWith("\"about\": \"t\",", ""))
                  .complaint()
                  .find("expected an object with a member \"about\""),
              std::string::npos);
}

TEST(Catalogue, RefusesAnUnknownState) {
    EXPECT_NE(OneMistake(exampleWith("blocked", "bocked"))
                  .complaint()
                  .find("/expect/T1/state: \"bocked\" is not known"),
              std::string::npos);
}

}  // namespace
}  // namespace ticker::corpus
