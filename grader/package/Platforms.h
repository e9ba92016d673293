#ifndef TICKER_PACKAGE_PLATFORMS_H
#define TICKER_PACKAGE_PLATFORMS_H

#include <grader/exercise/Exercise.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::package {

/// Paths of the installed parts, in a build tree or an installation.
struct Parts {
    const Exercise& exercise;       ///< what the platform grades
    std::filesystem::path program;  ///< ticker
    std::filesystem::path helper;   ///< ticker-jail
    std::filesystem::path decoder;  ///< ticker-decode
    std::filesystem::path kit;      ///< what submissions are compiled and linked with
    std::string compiler;           ///< of the kit, as an absolute path
    std::vector<std::string> compileFlags;
    std::vector<std::string> linkFlags;
    std::filesystem::path data;         ///< holds scenes/, assets/ and grader/integrations/
    std::filesystem::path rubric;       ///< the course's
    std::filesystem::path studentView;  ///< the course's: what students may see
};

/// Writes a zip for Gradescope's autograder page: setup.sh, run_autograder, ticker. It contains no
/// solution, no reference picture and no seed.
/// @throws raytracer::InputError if a part cannot be read or `file` cannot be written.
void writeGradescope(const Parts& parts, const std::filesystem::path& file);

/// Writes a zip for PrairieLearn: the Dockerfile of an external grader's image, its entry point,
/// ticker, and a question that uses it. It contains no solution, no reference picture and no seed.
/// @throws raytracer::InputError likewise.
void writePrairieLearn(const Parts& parts, const std::filesystem::path& file);

}  // namespace ticker::package

#endif
