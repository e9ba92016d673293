#ifndef TICKER_LAB_COVERAGE_COVERAGETABLES_H
#define TICKER_LAB_COVERAGE_COVERAGETABLES_H

#include <grader/exercise/Exercise.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace ticker::coverage {

struct CoverageRun {
    const Exercise* exercise = &defaultExercise();
    std::string only;       ///< cases whose name contains it
    double fraction = 1.0;  ///< share of them, evenly picked; at least one
    int jobs = 2;
    /// Called after each case, one call at a time; may be null.
    std::function<void(std::size_t done, std::size_t of)> progress;
};

struct Coverage {
    std::string text;  ///< Markdown: a summary, and a table for each task
    /// Right solutions on which a public test fails, a line each.
    std::vector<std::string> refused;
};

/// Runs the public tests on the catalogue, the samples and the unseen solutions.
/// @param root  The project's root.
/// @throws raytracer::InputError if no case is called so; raytracer::Error if our own files fail.
[[nodiscard]] Coverage measure(const std::filesystem::path& root, const CoverageRun& run);

}  // namespace ticker::coverage

#endif
