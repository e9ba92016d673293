#ifndef TICKER_INTAKE_SKIPPED_H
#define TICKER_INTAKE_SKIPPED_H

#include <grader/intake/Intake.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::intake {

/// A folder or archive (other than zip or tar) of a class that contains nothing to grade.
struct Skipped {
    std::string name;  ///< path below the class; untrusted, one line
    std::string why;   ///< "is empty"
};

/// Everything below a path that belongs to no submission found there, by name. Single files and
/// system files (.git, __MACOSX) are not listed.
/// @param out  The folder of this run's results, which is not listed either; may be empty.
[[nodiscard]] std::vector<Skipped> findSkipped(const std::filesystem::path& path,
                                               const std::vector<Located>& found,
                                               const std::filesystem::path& out = {});

}  // namespace ticker::intake

#endif
