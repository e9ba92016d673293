#include <grader/cli/Batch.h>
#include <grader/corpus/Entry.h>
#include <grader/result/ResultJson.h>
#include <grader/tests/pipeline/TestGrader.h>
#include <grader/tests/support/AsNobody.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <atomic>
#include <map>

namespace ticker::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kSeed = 20261121;

// In the class a hostile submission comes after every two honest ones.
const std::vector<std::string> kHonest{"awarded/reference-bump",       "notAwarded/bump-inverted-u",
                                       "notAwarded/bump-swapped-axes", "needsReview/no-screenshot",
                                       "notAwarded/does-not-compile",  "awarded/bump-z-up"};
const std::vector<std::string> kHostile{"fork-bomb", "memory-bomb", "scan-descriptors"};

// Name of a folder of the class that sorts to this place.
std::string nameOf(std::size_t place) {
    return "student-" + std::to_string(10 + place);
}

std::vector<intake::Located> makeClass(const fs::path& folder, bool withHostile) {
    const fs::path root{TICKER_SOURCE_DIR};
    const auto corpus = corpus::readEntries(root, {"hostile"});
    std::size_t honest = 0;
    for (std::size_t place = 0; place < kHonest.size() + kHostile.size(); ++place) {
        const fs::path target = folder / nameOf(place);
        if (place % 3 != 2) {
            fs::copy(root / "grader/corpus/samples" / kHonest.at(honest++), target);
        } else if (withHostile) {
            fs::create_directory(target);
            const auto found =
                std::ranges::find(corpus, kHostile.at(place / 3), &corpus::Entry::name);
            corpus::writeSubmission(*found, "/etc/hostname", target);
        }
    }
    return intake::findSubmissions(folder);
}

std::map<std::string, std::string> gradedTexts(const std::vector<intake::Located>& located,
                                               int workers) {
    std::map<std::string, std::string> texts;
    const std::atomic<bool> stop{false};
    BatchHooks hooks;
    hooks.take = [&](const intake::Located& each, SubmissionResult result, bool /*isKept*/) {
        result.timing = {};
        texts[each.name] = resultJson(result);
    };
    gradeAll(located, tests::testGrader(), kSeed, workers, stop, hooks);
    return texts;
}

TEST(GradeAll, GivesHonestSubmissionsBetweenHostileOnesTheResultsThatTheyGetAlone) {
    const tests::TemporaryFolder alone;
    const tests::TemporaryFolder mixed;
    const auto wanted = gradedTexts(makeClass(alone.path(), false), 1);
    const auto got = gradedTexts(makeClass(mixed.path(), true), 2);

    ASSERT_EQ(wanted.size(), kHonest.size());
    ASSERT_EQ(got.size(), kHonest.size() + kHostile.size());
    for (const auto& [name, text] : wanted)
        EXPECT_EQ(got.at(name), text) << name;
}

TEST(GradeAll, DoesNotGradeWhatItMayNotRead) {
    const tests::TemporaryFolder folder;
    folder.write("ann/BumpySphere.cpp", "int x;");
    fs::permissions(folder.path(), fs::perms{0755});
    fs::permissions(folder.path() / "ann/BumpySphere.cpp", fs::perms::none);
    const pipeline::Grader& grader = tests::testGrader();
    SubmissionResult graded;
    BatchHooks hooks;
    hooks.take = [&](const intake::Located& /*each*/, const SubmissionResult& result,
                     bool /*isKept*/) { graded = result; };
    const std::atomic<bool> stop{false};
    {
        const tests::AsNobody nobody;
        gradeAll({{"ann", folder.path() / "ann"}}, grader, kSeed, 1, stop, hooks);
    }
    EXPECT_EQ(graded.verdict, Verdict::notGraded);
    ASSERT_FALSE(graded.tasks.empty());
    EXPECT_NE(graded.tasks.front().reason.find("cannot be read: Permission denied"),
              std::string::npos)
        << graded.tasks.front().reason;
}

}  // namespace
}  // namespace ticker::cli
