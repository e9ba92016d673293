#include <grader/cli/Batch.h>

#include <grader/base/Workers.h>
#include <grader/pipeline/InputDigests.h>

#include <exception>
#include <mutex>
#include <string>
#include <utility>

namespace ticker::cli {
namespace {

constexpr int kTries = 2;

/// Outcome of one submission.
struct Graded {
    SubmissionResult result;
    bool isKept = false;
};

/// Grades submissions; shared by the workers.
class Batch {
public:
    Batch(const pipeline::Grader& grader, std::uint64_t seed, const BatchHooks& hooks)
        : grader_(grader), seed_(seed), hooks_(hooks) {}

    [[nodiscard]] Graded grade(const intake::Located& located) const {
        std::string reason;
        for (int attempt = 1; attempt <= kTries; ++attempt) {
            try {
                const intake::Submission submission =
                    intake::readSubmission(located, {.exercise = grader_.exercise});
                if (auto known = knownResult(located, submission)) return {std::move(*known), true};
                SubmissionResult result = pipeline::gradeSubmission(submission, grader_, seed_);
                if (result.verdict == Verdict::notGraded && attempt < kTries) continue;
                if (hooks_.complete) hooks_.complete(submission, result);
                return {std::move(result), false};
            } catch (const std::exception& error) {
                reason = error.what();
            }
        }
        return {pipeline::notGradedResult(located.name, reason, grader_, seed_), false};
    }

private:
    [[nodiscard]] std::optional<SubmissionResult> knownResult(
        const intake::Located& located, const intake::Submission& submission) const {
        if (!hooks_.known) return std::nullopt;
        return hooks_.known(located, pipeline::inputsOf(submission, grader_, seed_));
    }

    const pipeline::Grader& grader_;
    std::uint64_t seed_;
    const BatchHooks& hooks_;
};

}  // namespace

void gradeAll(const std::vector<intake::Located>& submissions, const pipeline::Grader& grader,
              std::uint64_t seed, int workers, const std::atomic<bool>& stop,
              const BatchHooks& hooks) {
    const Batch batch{grader, seed, hooks};
    std::mutex taking;
    bool hasFailed = false;
    onWorkers(workers, submissions.size(), [&](std::size_t i) {
        if (stop) return;
        const Graded graded = batch.grade(submissions[i]);
        try {
            if (!graded.isKept && hooks.write) hooks.write(graded.result);
            const std::lock_guard lock{taking};
            if (!hasFailed) hooks.take(submissions[i], graded.result, graded.isKept);
        } catch (...) {  // such as a full disk: no more results are taken
            const std::lock_guard lock{taking};
            hasFailed = true;
            throw;
        }
    });
}

}  // namespace ticker::cli
