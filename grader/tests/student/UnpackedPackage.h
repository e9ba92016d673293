#ifndef TICKER_TESTS_STUDENT_UNPACKEDPACKAGE_H
#define TICKER_TESTS_STUDENT_UNPACKEDPACKAGE_H

#include <grader/exercise/Exercise.h>
#include <grader/tests/support/RunCommand.h>
#include <grader/tests/support/TemporaryFolder.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::tests {

/// The students' package, made and unpacked in a temporary folder.
class UnpackedPackage {
public:
    explicit UnpackedPackage(const Exercise& exercise = defaultExercise());

    /// The folder that contains ./check.
    [[nodiscard]] std::filesystem::path folder() const;
    /// All files in it.
    [[nodiscard]] std::vector<std::filesystem::path> files() const;

    /// Runs a command in the folder, in a jail with only the system's programs and this folder: no
    /// network, no home, none of our variables. Where ccache is installed, what was compiled before
    /// is not compiled again: the jail has the user's cache.
    [[nodiscard]] CommandResult runAlone(const std::string& command) const;

private:
    std::string name_;
    TemporaryFolder work_;
};

}  // namespace ticker::tests

#endif
