#include <grader/cli/Explained.h>

#include <grader/repair/Explain.h>

#include <algorithm>
#include <exception>
#include <string>

namespace ticker::cli {

bool wantsRepairs(const SubmissionResult& result) {
    return !result.repairs && std::ranges::any_of(result.tasks, repair::isExplainable);
}

void addRepairs(const intake::Submission& submission, const pipeline::Grader& grader,
                SubmissionResult& result) {
    if (!wantsRepairs(result)) return;
    // Other questions than those of the verdict.
    constexpr std::uint64_t kOtherSeed = 0x9E3779B97F4A7C15U;
    try {
        repair::Explanation found =
            repair::explain(submission, grader, result, result.seed ^ kOtherSeed);
        result.repairs = std::move(found.repairs);
        for (const std::string& task : found.cutOff)
            result.notices.push_back(task +
                                     ": the time for the search ended before all edits of the "
                                     "code were tried.");
        for (const std::string& task : found.notSearched)
            result.notices.push_back(task +
                                     ": no edits were tried, since the code could not be parsed or "
                                     "not be compiled with them.");
    } catch (const std::exception& error) {
        result.notices.push_back("Edits were not looked for: " + std::string{error.what()});
    }
}

}  // namespace ticker::cli
