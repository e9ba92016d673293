#ifndef TICKER_TOOLS_PUBLICCOVERAGE_EXAMINE_H
#define TICKER_TOOLS_PUBLICCOVERAGE_EXAMINE_H

#include "Case.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::coverage {

/// What the public tests say about one case.
struct Outcome {
    enum class Kind { ran, doesNotCompile, crashed, notAttempted } kind = Kind::ran;
    std::vector<std::string> failed;  ///< names of the task's tests

    [[nodiscard]] bool objects() const { return kind != Kind::ran || !failed.empty(); }
};

/// Compiles a case, links it with the public tests and runs them.
/// @param root      The project's.
/// @param linkFile  What to link with: the compiler's @FILE.
/// @throws raytracer::Error where our own side fails.
[[nodiscard]] Outcome examine(const Case& one, const std::filesystem::path& root,
                              const std::filesystem::path& linkFile);

}  // namespace ticker::coverage

#endif
