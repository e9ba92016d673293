#ifndef TICKER_STORE_EARLIER_H
#define TICKER_STORE_EARLIER_H

#include <grader/result/SubmissionResult.h>

#include <filesystem>
#include <string>
#include <vector>

namespace ticker::store {

/// A result that a later grading replaced: `OUT/<submission>/earlier/<number>/`.
struct Earlier {
    SubmissionResult result;     ///< from its result.json
    std::filesystem::path code;  ///< folder of its sources
    std::string gradedAt;        ///< UTC, "2026-11-21T16:05:36Z"
};

/// True if the result in OUT stays, and `next` must not be written: `next` is notGraded, which is
/// no fault of the student's, and the one in OUT is a graded one of the same files.
[[nodiscard]] bool keepsBefore(const std::filesystem::path& out, const SubmissionResult& next);

/// Moves result.json and code/ of a submission to earlier/ if the new result is about other files,
/// or has another verdict or other findings. Pictures do not stay. A move that a kill has
/// interrupted is completed first. If the result in OUT is notGraded, it does not stay, and neither
/// does the newest earlier one if the new result agrees with it.
/// @throws raytracer::InputError if they cannot be moved; they are still in their place then.
void keepEarlier(const std::filesystem::path& out, const SubmissionResult& next);

/// The earlier results of a submission, newest first. Those that cannot be read are left out.
[[nodiscard]] std::vector<Earlier> earlierResults(const std::filesystem::path& out,
                                                  const std::string& submission);

}  // namespace ticker::store

#endif
