#ifndef TICKER_INTAKE_SKIPPED_H
#define TICKER_INTAKE_SKIPPED_H

#include <grader/intake/Intake.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::intake {

/// A folder of a class, or an archive that is no zip or tar, in which nothing is graded.
struct Skipped {
    std::string name;  ///< path below the class; untrusted, one line
    std::string why;   ///< "is empty"
};

/// What lies below a path and is part of no submission that was found there, by name. Loose files
/// and what the systems leave behind (.git, __MACOSX) are not told.
[[nodiscard]] std::vector<Skipped> findSkipped(const std::filesystem::path& path,
                                               const std::vector<Located>& found);

}  // namespace ticker::intake

#endif
