#ifndef TICKER_CLI_CLASSPATHS_H
#define TICKER_CLI_CLASSPATHS_H

#include <grader/intake/Intake.h>

#include <string>
#include <vector>

namespace ticker::cli {

/// Where the submissions of a command line lie.
struct ClassPaths {
    std::vector<std::string> paths;
    bool single = false;  ///< the path is one submission, whatever is in it: a platform says so
};

/// The submissions below all paths; a name that comes twice gets a number.
/// @throws raytracer::InputError where there is none, or a path cannot be read.
[[nodiscard]] std::vector<intake::Located> locate(const ClassPaths& from);

/// "2/5": the second, the seventh, the twelfth, ... of all, by name. Every machine of a cluster
/// finds the same.
/// @throws raytracer::InputError where `share` is no I/N with 1 <= I <= N.
[[nodiscard]] std::vector<intake::Located> shareOf(std::vector<intake::Located> all,
                                                   const std::string& share);

/// What lies beside the submissions and is not graded, in one line; empty: nothing.
[[nodiscard]] std::string skippedLine(const ClassPaths& from);

}  // namespace ticker::cli

#endif
