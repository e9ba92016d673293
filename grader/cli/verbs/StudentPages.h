#ifndef TICKER_CLI_STUDENTPAGES_H
#define TICKER_CLI_STUDENTPAGES_H

#include <grader/report/StudentView.h>
#include <grader/store/ClassFolder.h>

#include <filesystem>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ticker::cli {

/// Adds --student-view to a verb: a policy file; empty: the kit's own.
void addStudentView(CLI::App& verb, std::string& file);

/// The policy in a file, or the kit's own where none is given.
/// @throws raytracer::InputError as `report::readStudentPolicy`.
[[nodiscard]] report::StudentPolicy policyFrom(const std::string& file);

/// True where a person decided about the submission.
[[nodiscard]] bool isDecided(const store::ClassEntry& entry);

/// What a student may see of the result as it counts: as a person decided, or as the tool proposes.
[[nodiscard]] report::StudentView studentViewOf(const store::ClassEntry& entry,
                                                const report::StudentPolicy& policy);

/// The same as a page, with the pictures that lie below OUT.
[[nodiscard]] std::string studentPageOf(const std::filesystem::path& out,
                                        const store::ClassEntry& entry,
                                        const report::StudentPolicy& policy);

/// Writes each `OUT/<submission>/student.html`: what a student may see, as decided or proposed.
/// @param studentView  As of `policyFrom`.
std::vector<std::filesystem::path> writeStudentPages(const std::filesystem::path& out,
                                                     const std::vector<store::ClassEntry>& entries,
                                                     const std::string& studentView);

}  // namespace ticker::cli

#endif
