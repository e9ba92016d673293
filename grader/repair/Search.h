#ifndef TICKER_REPAIR_SEARCH_H
#define TICKER_REPAIR_SEARCH_H

#include <grader/exercise/Task.h>
#include <grader/repair/Candidates.h>
#include <grader/repair/Clock.h>
#include <grader/repair/EditSets.h>
#include <grader/repair/SwitchedProgram.h>

#include <cstdint>
#include <functional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace ticker::repair {

/// A set of edits that leaves another finding.
struct Partial {
    EditSet set;
    std::string next;                   ///< the first failing finding that is left
    std::vector<std::string> failures;  ///< all that are left, sorted
};

/// Looks for sets of edits with which a submission passes a task: cheap questions first, then the
/// task's own judge under one seed. What it finds is a suspicion until it is proven.
class Search {
public:
    /// All of them must outlive this object.
    /// @param others  Tasks that the submission passes: it has to pass them with an edit, too.
    /// @param before  What the submission got without edits: an edit must not add a warning.
    Search(const Task& task, const TaskJudgement& before, const std::vector<const Task*>& others,
           SwitchedProgram& program, std::uint64_t seed, const Clock& clock);

    /// Calls `use` for those of the sets with which the judge passes the submission, roughly in
    /// their order, until the clock's time is up.
    /// @param use  Takes one of them; returns false if no more are wanted.
    void eachPassing(std::span<const EditSet> sets, const std::function<bool(const EditSet&)>& use);

    /// Those of the sets with which the judge's first failing finding is the name of another
    /// mistake than `finding`, until the clock's time is up. Names that few of them lead to come
    /// first: many edits make a surface flat, few mend one of two mistakes.
    [[nodiscard]] std::vector<Partial> changing(std::span<const EditSet> sets,
                                                const std::string& finding);

    /// Whether a screened set changed no answer to the cheap questions, or ended the process.
    /// Always false if the submission may pass these questions without edits.
    [[nodiscard]] bool isIdle(const EditSet& set) const { return idle_.contains(set); }

    /// Number of sets that were asked the cheap questions so far; 0 if the task has none.
    [[nodiscard]] std::size_t asked() const { return asked_; }

private:
    /// Chooses the cheap questions, if possible some that the submission fails without edits.
    void drawScreening();
    /// Finds the questions at which the judge ends without edits, if the first ones do not show the
    /// mistake.
    void findDeciding();
    /// Takes cheap questions if they are the first, or if the submission fails them without edits.
    /// @return  Whether it does.
    bool takeScreening(Screening drawn);
    [[nodiscard]] std::vector<EditSet> screened(std::span<const EditSet> sets);
    /// Those with which the submission still passes the cheap questions that it passes without.
    [[nodiscard]] std::vector<EditSet> stillPassing(std::span<const EditSet> sets);
    [[nodiscard]] TaskJudgement judge(const EditSet& set, probe::Run first) const;
    [[nodiscard]] bool passesOthers(const EditSet& set) const;
    /// What the sets answer first; without a value for those that leave the mistake as it is.
    [[nodiscard]] std::vector<std::optional<probe::Run>> firstRuns(
        std::span<const EditSet> sets) const;
    /// Judges each set whose answers differ from those without edits.
    /// @param use  Takes a set and its judgement; false: no more are judged.
    /// @return  False if `use` wanted no more.
    template <class Use>
    bool judgeEach(std::span<const EditSet> sets, Use use);

    const Task& task_;
    const TaskJudgement& before_;
    Judge judge_;
    std::vector<Judge> others_;
    const SwitchedProgram& program_;
    std::uint64_t seed_;
    const Clock& clock_;
    std::vector<probe::Question> first_;     ///< what the judge asks first
    probe::Run asHandedIn_;                  ///< the answers to them without edits
    std::vector<probe::Question> deciding_;  ///< what it asks last without edits, if not first
    probe::Run decidedAsHandedIn_;           ///< the answers to them without edits
    Screening screening_;                    ///< the cheap questions, if the task has any
    probe::Run screenedAsHandedIn_;          ///< the answers to them without edits
    Screening passed_;     ///< the first cheap questions, if `screening_` are others
    bool isSeen_ = false;  ///< whether the submission fails the cheap questions without edits
    std::size_t asked_ = 0;
    std::set<EditSet> idle_;
};

}  // namespace ticker::repair

#endif
