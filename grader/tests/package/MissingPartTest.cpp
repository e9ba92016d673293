#include <grader/package/Platforms.h>
#include <grader/package/StudentPackage.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <raytracer/base/Error.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace ticker::package {
namespace {

namespace fs = std::filesystem;

TEST(MissingPart, OfTheStudentsPackageIsNamed) {
    const tests::TemporaryFolder folder;
    const fs::path file = folder.path() / "package.zip";
    try {
        writeStudentPackage(folder.path(), defaultExercise(), file);
        FAIL() << "there is no template";
    } catch (const raytracer::InputError& error) {
        EXPECT_EQ(std::string{error.what()},
                  (folder.path() / "student_template/.devcontainer").string() +
                      ": cannot be read: No such file or directory");
    }
    EXPECT_FALSE(fs::exists(file));
}

/// Parts of which all but the compiler are there.
Parts partsWithoutACompiler(const tests::TemporaryFolder& folder) {
    const fs::path any = folder.write("any", "");
    return {.exercise = defaultExercise(),
            .program = any,
            .helper = any,
            .decoder = any,
            .kit = folder.path(),
            .compiler = "/not/there/g++-12",
            .compileFlags = {},
            .linkFlags = {},
            .data = TICKER_SOURCE_DIR,
            .rubric = any,
            .studentView = any};
}

TEST(MissingPart, OfAPlatformsPackageIsNamedWhereItIsTheCompiler) {
    const tests::TemporaryFolder folder;
    try {
        writeGradescope(partsWithoutACompiler(folder), folder.path() / "gradescope.zip");
        FAIL() << "there is no compiler";
    } catch (const raytracer::InputError& error) {
        EXPECT_EQ(std::string{error.what()},
                  "/not/there/g++-12: the compiler of the kit cannot be found: No such file or "
                  "directory; install it, or build again with another");
    }
    EXPECT_FALSE(fs::exists(folder.path() / "gradescope.zip"));
}

}  // namespace
}  // namespace ticker::package
