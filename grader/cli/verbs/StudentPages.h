#ifndef TICKER_CLI_STUDENTPAGES_H
#define TICKER_CLI_STUDENTPAGES_H

#include <grader/report/student/StudentView.h>
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

/// The policy of a file, or the kit's own for an empty name.
/// @throws raytracer::InputError as `report::readStudentPolicy`.
[[nodiscard]] report::StudentPolicy policyFrom(const std::string& file);

/// True if a ticker has decided about the submission.
[[nodiscard]] bool isDecided(const store::ClassEntry& entry);

/// True if the decision is about other files than the result: those of an earlier hand-in.
[[nodiscard]] bool isStale(const store::ClassEntry& entry);

/// Prints a warning on stderr that names the submissions with a stale decision, if there are any.
/// @param decidedOnly  Their marks are not written, and the warning says so.
void warnOfStale(const std::vector<store::ClassEntry>& entries, bool decidedOnly);

/// The student's view of the valid result: the ticker's decision, or the tool's proposal.
[[nodiscard]] report::StudentView studentViewOf(const store::ClassEntry& entry,
                                                const report::StudentPolicy& policy);

/// The view as a page, with the pictures below OUT.
[[nodiscard]] std::string studentPageOf(const std::filesystem::path& out,
                                        const store::ClassEntry& entry,
                                        const report::StudentPolicy& policy);

/// Writes each `OUT/<submission>/student.html`, from the decision or the proposal.
/// @param studentView  Name of a policy file, see `policyFrom`.
std::vector<std::filesystem::path> writeStudentPages(const std::filesystem::path& out,
                                                     const std::vector<store::ClassEntry>& entries,
                                                     const std::string& studentView);

}  // namespace ticker::cli

#endif
