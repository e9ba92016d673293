#include <grader/cli/Batch.h>

#include <exception>
#include <mutex>
#include <string>
#include <thread>

namespace ticker::cli {
namespace {

SubmissionResult gradeOne(const intake::Located& located, const pipeline::Grader& grader,
                          std::uint64_t seed) {
    constexpr int kTries = 2;
    std::string reason;
    for (int attempt = 0; attempt < kTries; ++attempt) {
        try {
            SubmissionResult result =
                pipeline::gradeSubmission(intake::readSubmission(located), grader, seed);
            if (result.verdict != Verdict::notGraded || attempt + 1 == kTries) return result;
        } catch (const std::exception& error) {
            reason = error.what();
        }
    }
    return pipeline::notGradedResult(located.name, reason, grader, seed);
}

}  // namespace

void gradeAll(const std::vector<intake::Located>& submissions, const pipeline::Grader& grader,
              std::uint64_t seed, int workers, const std::atomic<bool>& stop,
              const std::function<void(const intake::Located&, const SubmissionResult&)>& take) {
    std::atomic<std::size_t> next{0};
    std::mutex taking;
    std::exception_ptr failure;
    const auto work = [&] {
        for (std::size_t i = next++; i < submissions.size() && !stop; i = next++) {
            const SubmissionResult result = gradeOne(submissions[i], grader, seed);
            const std::lock_guard lock{taking};
            if (failure) return;
            try {
                take(submissions[i], result);
            } catch (...) {
                failure = std::current_exception();  // such as a full disk: no sense in going on
                next = submissions.size();
            }
        }
    };
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < workers; ++i)
            threads.emplace_back(work);
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace ticker::cli
