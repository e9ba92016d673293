#include <grader/sandbox/JobFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>

namespace ticker::sandbox {
namespace {

namespace fs = std::filesystem;

TEST(JobFolder, WritesWhatEveryUserCanRead) {
    const JobFolder folder;
    folder.write("a.cpp", std::string_view{"int a;\0", 7});
    const fs::path file = folder.path() / "a.cpp";
    EXPECT_EQ(fs::file_size(file), 7U);
    EXPECT_EQ(fs::status(file).permissions(), fs::perms{0644});
}

TEST(JobFolder, NamesTheFileThatItCannotWrite) {
    const JobFolder folder;
    try {
        folder.write("not-there/a.cpp", "int a;");
        FAIL() << "it was written";
    } catch (const raytracer::Error& error) {
        EXPECT_EQ(std::string{error.what()}, "cannot write " +
                                                 (folder.path() / "not-there/a.cpp").string() +
                                                 "; is the disk full? TMPDIR names another one");
    }
}

}  // namespace
}  // namespace ticker::sandbox
