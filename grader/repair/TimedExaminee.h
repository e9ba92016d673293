#ifndef TICKER_REPAIR_TIMEDEXAMINEE_H
#define TICKER_REPAIR_TIMEDEXAMINEE_H

#include <grader/probe/Examinee.h>
#include <grader/repair/Clock.h>

#include <functional>
#include <utility>
#include <vector>

namespace ticker::repair {

/// A submission that is asked until the time of its explanation is used up: a judge then gets no
/// answer and ends soon. Judging takes CPU time of its own, which the processes' limits do not
/// cover.
class TimedExaminee final : public probe::Examinee {
public:
    /// The submission and the clock must outlive this object.
    /// @param cpuMs  What the submission's processes have taken so far.
    TimedExaminee(probe::Examinee& submission, std::function<double()> cpuMs, Clock& clock)
        : submission_(submission), cpuMs_(std::move(cpuMs)), clock_(clock) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override {
        if (clock_.isAllUsedUp())
            return {{}, {probe::ProcessEnd::Kind::timedOut, "the search is over"}};
        const double beginMs = cpuMs_();
        probe::Run run = submission_.ask(questions);
        clock_.add(Work::prove, cpuMs_() - beginMs);
        return run;
    }

private:
    probe::Examinee& submission_;
    std::function<double()> cpuMs_;
    Clock& clock_;
};

}  // namespace ticker::repair

#endif
