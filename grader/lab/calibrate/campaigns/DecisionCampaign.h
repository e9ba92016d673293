#ifndef TICKER_CALIBRATE_DECISIONCAMPAIGN_H
#define TICKER_CALIBRATE_DECISIONCAMPAIGN_H

#include <grader/exercise/Task.h>
#include <grader/lab/calibrate/Campaign.h>
#include <grader/lab/calibrate/Subject.h>

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::calibrate {

/// What a campaign of decisions judges, and how often.
struct DecisionPlan {
    std::string name;
    std::vector<Subject> subjects;
    /// Number of decisions on a subject, rounded up to whole blocks; 0: none.
    std::function<std::size_t(const Subject&)> decisions;
    std::size_t block = 50;  ///< decisions of a unit
    /// Whether the other tasks of a subject's file are judged, too: for right subjects in every
    /// block, for wrong ones in the first block only.
    bool othersToo = true;
    /// Names of the subjects of which `--check` repeats the first block.
    std::vector<std::string_view> checked;
    /// Makes the campaign's tables from its subjects and records.
    std::function<Summary(const std::vector<Subject>&, const std::vector<std::string>&)> tables;
};

/// Judges subjects repeatedly, each time with another seed. Subjects whose rays are not visible get
/// the same questions, so that a task's `judgeOfMany` keeps what it computes for them, but each has
/// random numbers of its own. A unit is a block of decisions about one task of one subject, so that
/// an edit of a task's checks makes only that task's units stale. Each round covers all subjects,
/// so that a stopped campaign has tried them all.
class DecisionCampaign final : public Campaign {
public:
    /// @param programs  Must outlive this object.
    DecisionCampaign(DecisionPlan plan, Programs& programs);

    [[nodiscard]] std::string name() const override { return plan_.name; }
    [[nodiscard]] std::size_t units() const override { return blocks_.size(); }
    [[nodiscard]] std::string unitName(std::size_t unit) const override;
    [[nodiscard]] Basis basisOf(std::size_t unit) const override;
    [[nodiscard]] std::vector<std::size_t> checkUnits() const override;
    [[nodiscard]] std::string run(std::size_t unit) override;
    [[nodiscard]] Summary summarise(const std::vector<std::string>& records) const override;

private:
    struct Block {
        std::size_t subject;
        std::string task;
        std::size_t round;
    };
    void addBlocks(std::size_t subject, std::size_t round);
    [[nodiscard]] const Subject& subjectOf(std::size_t unit) const {
        return plan_.subjects.at(blocks_.at(unit).subject);
    }

    struct JudgeOfTask {
        explicit JudgeOfTask(const Task& task)
            : judge(judgeOfMany(task)), isOfMany(task.judgeOfMany != nullptr) {}
        Judge judge;
        bool isOfMany;
    };

    DecisionPlan plan_;
    std::vector<Block> blocks_;
    std::map<std::string, JudgeOfTask> judges_;  // by the task's id
    Programs& programs_;
};

/// Subjects that must pass. Expected: none fails, at most 0.1 % need review.
[[nodiscard]] std::vector<Subject> rightOnes(const std::vector<Subject>& subjects);
/// Subjects that must fail. Expected: none passes, at least 98 % get the right name.
[[nodiscard]] std::vector<Subject> wrongOnes(const std::vector<Subject>& subjects);

}  // namespace ticker::calibrate

#endif
