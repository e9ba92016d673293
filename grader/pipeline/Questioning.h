#ifndef TICKER_PIPELINE_QUESTIONING_H
#define TICKER_PIPELINE_QUESTIONING_H

#include <grader/build/SandboxedExaminee.h>
#include <grader/pipeline/Grade.h>

#include <future>
#include <mutex>
#include <utility>

namespace ticker::pipeline {

/// Asks one program in several runs, which may be parallel.
class Questioning {
public:
    Questioning(const build::Program& program, const Grader& grader, build::TimeBudget& budget)
        : program_(program), grader_(grader), budget_(budget) {}

    /// Starts `work(examinee)`: at once if this submission is graded alone, otherwise when its
    /// result is requested.
    template <class Work>
    auto begin(Work work) {
        return std::async(grader_.isAlone ? std::launch::async : std::launch::deferred,
                          [this, work = std::move(work)] { return run(work); });
    }

    /// Runs `work(examinee)`.
    template <class Work>
    auto run(const Work& work) {
        build::SandboxedExaminee examinee{program_, grader_.sandbox, grader_.policy.run, &budget_};
        auto result = work(examinee);
        const std::lock_guard lock{mutex_};
        wallMs_ += examinee.wallMs();
        madeForbiddenCall_ = madeForbiddenCall_ || examinee.madeForbiddenCall();
        return result;
    }

    /// Wall time of all runs that have ended.
    [[nodiscard]] double wallMs() const { return wallMs_; }
    /// Whether one of them was ended at a forbidden system call.
    [[nodiscard]] bool madeForbiddenCall() const { return madeForbiddenCall_; }

private:
    const build::Program& program_;
    const Grader& grader_;
    build::TimeBudget& budget_;
    std::mutex mutex_;
    bool madeForbiddenCall_ = false;
    double wallMs_ = 0.0;
};

}  // namespace ticker::pipeline

#endif
