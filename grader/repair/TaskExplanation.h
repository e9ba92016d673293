#ifndef TICKER_REPAIR_TASKEXPLANATION_H
#define TICKER_REPAIR_TASKEXPLANATION_H

#include <grader/pipeline/Grade.h>
#include <grader/repair/Clock.h>
#include <grader/repair/EditSets.h>
#include <grader/repair/Search.h>
#include <grader/repair/SearchLimits.h>
#include <grader/repair/Workbench.h>
#include <grader/result/Repair.h>
#include <grader/result/SubmissionResult.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ticker::repair {

/// What the explanations of a submission's tasks share.
struct Setting {
    const SubmissionResult& result;
    const pipeline::Grader& grader;
    const SearchLimits& limits;
    std::uint64_t seed;
    Clock& clock;
};

/// What was found for one failed task.
struct TaskRepairs {
    std::vector<Repair> repairs;
    std::size_t asked = 0;   ///< sets of edits that were asked
    bool wasCutOff = false;  ///< the time of some kind ended before all of its edits were tried
};

/// The search for edits that mend one failed task.
class TaskExplanation {
public:
    /// All of them must outlive this object.
    /// @param endMs  The clock's CPU time at which the search ends; it begins now.
    TaskExplanation(Workbench& workbench, const TaskReport& task, const Setting& setting,
                    double endMs);

    /// Tries kinds of edits one after the other, the simplest first, until one of them is proven.
    [[nodiscard]] TaskRepairs run();

private:
    using Repairs = std::vector<Repair>;
    using MakeSets = std::vector<EditSet> (*)(std::string_view, const Candidates&, const Choice&);

    /// The clock's CPU time when a share of this task's time is over.
    [[nodiscard]] double timeAt(double share) const {
        return beginMs_ + share * (endMs_ - beginMs_);
    }

    [[nodiscard]] Repairs noLongerStatic();
    [[nodiscard]] Repairs formulas();
    [[nodiscard]] Repairs doubleForInt();
    [[nodiscard]] Repairs anyOf(Reach reach, MakeSets make);
    [[nodiscard]] Repairs twoMistakes();
    [[nodiscard]] Repairs compiledApart();

    /// Those of the sets that are proven, within the task's time.
    [[nodiscard]] Repairs proven(const Bench& bench, const std::vector<EditSet>& sets);
    /// The same of those that pass the search.
    [[nodiscard]] Repairs proven(Search& search, const Bench& bench,
                                 const std::vector<EditSet>& sets);
    [[nodiscard]] std::optional<Repair> provenOne(const Bench& bench, const EditSet& set,
                                                  const std::string& next);
    /// Whether a set leaves some of the findings and adds none.
    [[nodiscard]] bool mendsSome(const Partial& partial) const;
    [[nodiscard]] Search& searchOf(Reach reach, Bench& bench);
    [[nodiscard]] std::vector<const Task*> othersOfTheFunction() const;
    [[nodiscard]] Choice choice() const;
    [[nodiscard]] bool isOfAnotherTask(const std::string& function) const;

    Workbench& workbench_;
    const TaskReport& task_;
    Setting setting_;
    std::string finding_;
    double beginMs_;
    double endMs_;
    std::map<Reach, Search> searches_;
};

}  // namespace ticker::repair

#endif
