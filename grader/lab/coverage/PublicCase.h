#ifndef TICKER_LAB_COVERAGE_PUBLICCASE_H
#define TICKER_LAB_COVERAGE_PUBLICCASE_H

#include <grader/exercise/Exercise.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ticker::coverage {

/// A solution with a known result for the public tests.
struct Case {
    std::string task;                          ///< a task, or an option for a whole file
    std::string name;                          ///< "inverted-u", "sample bump-inverted"
    std::string title;                         ///< a short description of its mistake
    bool right = false;                        ///< no public test may fail
    std::map<std::string, std::string> files;  ///< name -> text; missing files are the reference's
};

/// The catalogue of mistakes and accepted readings, the sample class, and the unseen solutions.
/// @param root  The project's root.
[[nodiscard]] std::vector<Case> listCases(const std::filesystem::path& root,
                                          const Exercise& exercise);

}  // namespace ticker::coverage

#endif
