#ifndef TICKER_REPAIR_SEARCH_H
#define TICKER_REPAIR_SEARCH_H

#include <grader/exercise/Task.h>
#include <grader/repair/Candidates.h>
#include <grader/repair/EditSets.h>
#include <grader/repair/SwitchedProgram.h>

#include <cstdint>
#include <span>
#include <vector>

namespace ticker::repair {

/// Looks for sets of edits with which a submission passes a task: cheap questions first, then the
/// task's own judge under one seed. What it finds is a suspicion until it is proven.
class Search {
public:
    /// All of them must outlive this object.
    Search(const Task& task, const SwitchedProgram& program, std::uint64_t seed);

    /// Those of the sets with which the judge passes the submission, in their order, until the time
    /// is up.
    /// @param deadlineMs  Of `spentMs`.
    [[nodiscard]] std::vector<EditSet> passing(std::span<const EditSet> sets, double deadlineMs);

    /// CPU time so far, of this thread and of the submission's processes.
    [[nodiscard]] double spentMs() const;
    /// Sets that were asked so far.
    [[nodiscard]] std::size_t asked() const { return asked_; }

private:
    [[nodiscard]] std::vector<EditSet> screened(std::span<const EditSet> sets, double deadlineMs);
    [[nodiscard]] bool judge(const EditSet& set, probe::Run first) const;

    const Task& task_;
    const SwitchedProgram& program_;
    std::uint64_t seed_;
    double startMs_;  ///< of this thread and of the program, before the search
    Screening screening_;
    std::vector<probe::Question> first_;  ///< what the judge asks first
    probe::Run asHandedIn_;               ///< the answers to them without edits
    probe::Run screenedAsHandedIn_;
    std::size_t asked_ = 0;
};

}  // namespace ticker::repair

#endif
