#ifndef TICKER_CALIBRATE_STAGECAMPAIGN_H
#define TICKER_CALIBRATE_STAGECAMPAIGN_H

#include <grader/lab/calibrate/Campaign.h>
#include <grader/lab/calibrate/Subject.h>
#include <grader/tasks/lens/checks/Expectations.h>
#include <grader/tasks/shadows/penumbra/PenumbraExpectations.h>

#include <cstdint>

namespace ticker::calibrate {

/// Measures how near right submissions whose rays are not visible come to the limits of a single
/// statistical stage. A verdict of failure takes two failed stages. A unit is a block of stages of
/// one kind on one subject.
class StageCampaign final : public Campaign {
public:
    /// @param subjects  All subjects; the campaign uses the right ones whose rays are not visible.
    /// @param units     Number of units of each kind of stage.
    /// @param programs  Must outlive this object.
    StageCampaign(const std::vector<Subject>& subjects, std::size_t units, Programs& programs);

    [[nodiscard]] std::string name() const override { return "stages"; }
    [[nodiscard]] std::size_t units() const override { return 2 * units_; }
    [[nodiscard]] std::string unitName(std::size_t unit) const override;
    [[nodiscard]] Basis basisOf(std::size_t unit) const override;
    [[nodiscard]] std::vector<std::size_t> checkUnits() const override { return {0, 1}; }
    [[nodiscard]] std::string run(std::size_t unit) override;
    [[nodiscard]] bool agrees(const std::string& before, const std::string& now) const override;
    [[nodiscard]] Summary summarise(const std::vector<std::string>& records) const override;

private:
    [[nodiscard]] const Subject& subjectOf(std::size_t unit) const;
    [[nodiscard]] std::string seedName(std::size_t unit) const;

    std::vector<Subject> shadows_;   // judged by values
    std::vector<Subject> pictures_;  // judged by pictures
    std::size_t units_;
    Programs& programs_;
    tasks::PenumbraShelf penumbraShelf_;
    tasks::ExpectationShelf pictureShelf_;
};

}  // namespace ticker::calibrate

#endif
