#ifndef TICKER_REPAIR_PROOF_H
#define TICKER_REPAIR_PROOF_H

#include <grader/pipeline/Grade.h>
#include <grader/repair/Clock.h>
#include <grader/result/SubmissionResult.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::repair {

/// What was proven about an edited file.
struct Proof {
    /// The first failing finding that the task has left under every seed; empty: it passes.
    std::string next;
};

/// Compiles the edited file as a submission is compiled and has the task judged in full under three
/// fresh seeds. Where it passes, the renders of its scenes are looked at as well, and the file's
/// other tasks that passed before must still pass. No task gets a warning that it did not have.
/// @param before  What the submission got without the edit.
/// @param clock   The CPU time of the compiler and of the program is added.
/// @return  Empty where the seeds do not agree, where anything else speaks against the edit, or
///          where the clock's time is used up before all of this is known.
[[nodiscard]] std::optional<Proof> prove(const std::string& edited, const std::string& file,
                                         const std::string& task,
                                         const std::vector<TaskReport>& before,
                                         const pipeline::Grader& grader, std::uint64_t seed,
                                         Clock& clock);

}  // namespace ticker::repair

#endif
