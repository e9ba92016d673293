#include <grader/base/Digest.h>
#include <grader/base/WholeFile.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

namespace ticker {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t filesIn(const fs::path& folder) {
    return std::distance(fs::directory_iterator{folder}, {});
}

TEST(WholeFile, GivesBackTheBytesThatWereWritten) {
    const tests::TemporaryFolder folder;
    const std::string bytes{"a\0\r\nb", 5};
    writeAtomically("longer than what follows", folder.path() / "file");
    writeAtomically(bytes, folder.path() / "file");
    EXPECT_EQ(readWhole(folder.path() / "file"), bytes);
    EXPECT_EQ(filesIn(folder.path()), 1);
}

TEST(WholeFile, NamesTheFileThatCannotBeReadOrWritten) {
    const tests::TemporaryFolder folder;
    const std::string missing = (folder.path() / "missing/file").string();
    EXPECT_EQ(readIfThere(missing), std::nullopt);
    const auto message = [](const auto& work) -> std::string {
        try {
            work();
        } catch (const raytracer::InputError& error) {
            return error.what();
        }
        return "nothing was thrown";
    };
    EXPECT_EQ(message([&] { static_cast<void>(readWhole(missing, "is not there")); }),
              missing + ": is not there");
    EXPECT_EQ(message([&] { writeAtomically("text", missing); }),
              missing + ": cannot be written; is the folder there and the disk not full?");
}

TEST(WholeFile, TakesAFolderForAFileThatCannotBeRead) {
    const tests::TemporaryFolder folder;
    EXPECT_EQ(readIfThere(folder.path()), std::nullopt);
    EXPECT_THROW(static_cast<void>(readWhole(folder.path())), raytracer::InputError);
}

TEST(WholeFile, ReadsAFileThatIsLongerThanOnePiece) {
    const tests::TemporaryFolder folder;
    const std::string bytes(200'000, 'x');
    writeAtomically(bytes, folder.path() / "file");
    EXPECT_EQ(readWhole(folder.path() / "file"), bytes);
    writeAtomically("", folder.path() / "file");
    EXPECT_EQ(readIfThere(folder.path() / "file"), "");
}

TEST(PartFile, LeavesTheTargetAloneUntilItIsRenamed) {
    const tests::TemporaryFolder folder;
    const fs::path target = folder.path() / "file";
    writeAtomically("before", target);
    {
        const PartFile part{target};
        ASSERT_TRUE(part.write("after"));
        EXPECT_EQ(readWhole(target), "before");
    }
    EXPECT_EQ(readWhole(target), "before");
    EXPECT_EQ(filesIn(folder.path()), 1);
}

TEST(Digest, TellsListsOfTextsApartAndReadsFilesAsTexts) {
    EXPECT_EQ(Digest{}.add("abc").text(), Digest{}.add("abc").text());
    EXPECT_NE(Digest{}.add("ab").add("c").text(), Digest{}.add("a").add("bc").text());
    EXPECT_EQ(Digest{}.text(), "e3b0c44298fc1c149afbf4c8996fb924");
    const tests::TemporaryFolder folder;
    writeAtomically("one", folder.path() / "one");
    writeAtomically("two", folder.path() / "two");
    EXPECT_NE(Digest{}.addFile(folder.path() / "one").text(),
              Digest{}.addFile(folder.path() / "two").text());
}

}  // namespace
}  // namespace ticker
