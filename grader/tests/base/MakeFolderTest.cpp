#include <grader/base/MakeFolder.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace ticker {
namespace {

TEST(MakeFolder, MakesThoseAboveItAndLeavesOneThatIsThere) {
    const tests::TemporaryFolder folder;
    const std::filesystem::path wanted = folder.path() / "new/folder";
    makeFolder(wanted);
    EXPECT_TRUE(std::filesystem::is_directory(wanted));
    makeFolder(wanted);
}

TEST(MakeFolder, NamesTheFolderThatCannotBeMadeAndTheReason) {
    const tests::TemporaryFolder folder;
    folder.write("file", "");
    const auto messageFor = [](const std::string& path) -> std::string {
        try {
            makeFolder(path);
        } catch (const raytracer::InputError& error) {
            return error.what();
        }
        return "nothing was thrown";
    };
    const std::string below = (folder.path() / "file/below").string();
    EXPECT_EQ(messageFor(below), below + ": cannot be made: Not a directory");
    const std::string tooLong = (folder.path() / std::string(300, 'x')).string();
    EXPECT_EQ(messageFor(tooLong), tooLong + ": cannot be made: File name too long");
}

}  // namespace
}  // namespace ticker
