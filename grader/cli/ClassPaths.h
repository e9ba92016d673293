#ifndef TICKER_CLI_CLASSPATHS_H
#define TICKER_CLI_CLASSPATHS_H

#include <grader/exercise/Exercise.h>
#include <grader/intake/Intake.h>

#include <span>
#include <string>
#include <vector>

namespace ticker::cli {

/// The submissions' paths on a command line.
struct ClassPaths {
    std::vector<std::string> paths;
    bool single = false;  ///< the path is one submission, whatever it contains (set by platforms)
    const Exercise* exercise = &defaultExercise();  ///< the exercise whose files are looked for
    std::string out = {};  ///< where results go: no submission, although it may lie in a path
};

/// The submissions below all paths; a repeated name gets a number that makes it unique.
/// @throws raytracer::InputError if there are no submissions, or a path cannot be read.
[[nodiscard]] std::vector<intake::Located> locate(const ClassPaths& from);

/// @param submissions  The result of `locate(from)`.
/// @param others  The exercises that are told apart from the wanted one.
/// @throws raytracer::InputError if the class is another exercise's, or mixes two. A single
///         submission is left to intake, which tells its student.
void expectOneExercise(const ClassPaths& from, const std::vector<intake::Located>& submissions,
                       std::span<const Exercise> others = knownExercises());

/// A share of all submissions by name: "2/5" is the second, the seventh, the twelfth, ... Every
/// machine of a cluster computes the same shares.
/// @throws raytracer::InputError unless `share` is I/N with 1 <= I <= N.
[[nodiscard]] std::vector<intake::Located> shareOf(std::vector<intake::Located> all,
                                                   const std::string& share);

/// One line about the folders that are not graded; empty if there are none.
[[nodiscard]] std::string skippedLine(const ClassPaths& from);

}  // namespace ticker::cli

#endif
