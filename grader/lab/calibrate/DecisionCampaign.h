#ifndef TICKER_CALIBRATE_DECISIONCAMPAIGN_H
#define TICKER_CALIBRATE_DECISIONCAMPAIGN_H

#include <grader/lab/calibrate/Campaign.h>
#include <grader/lab/calibrate/Subject.h>

#include <functional>

namespace ticker::calibrate {

/// Judges subjects repeatedly, each time with another seed. A unit is a block of decisions on one
/// subject. Each round covers all subjects, so that a stopped campaign has tried them all.
class DecisionCampaign final : public Campaign {
public:
    /// @param decisions  Number of decisions on a subject, rounded up to whole blocks; 0: none.
    /// @param programs   Must outlive this object.
    DecisionCampaign(std::string name, std::vector<Subject> subjects,
                     const std::function<std::size_t(const Subject&)>& decisions,
                     Programs& programs);

    [[nodiscard]] std::string name() const override { return name_; }
    [[nodiscard]] std::size_t units() const override { return blocks_.size(); }
    [[nodiscard]] std::string unitName(std::size_t unit) const override;
    [[nodiscard]] std::vector<std::size_t> checkUnits() const override;
    [[nodiscard]] std::string run(std::size_t unit) override;
    [[nodiscard]] Summary summarise(const std::vector<std::string>& records) const override;

private:
    struct Block {
        std::size_t subject;
        std::size_t round;
    };
    std::string name_;
    std::vector<Subject> subjects_;
    std::vector<Block> blocks_;
    Programs& programs_;
};

/// Subjects that must pass. Expected: none fails, at most 0.1 % need review.
[[nodiscard]] std::vector<Subject> rightOnes(const std::vector<Subject>& subjects);
/// Subjects that must fail. Expected: none passes, at least 98 % get the right name.
[[nodiscard]] std::vector<Subject> wrongOnes(const std::vector<Subject>& subjects);

}  // namespace ticker::calibrate

#endif
