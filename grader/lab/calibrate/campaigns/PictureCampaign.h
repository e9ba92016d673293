#ifndef TICKER_CALIBRATE_PICTURECAMPAIGN_H
#define TICKER_CALIBRATE_PICTURECAMPAIGN_H

#include <grader/lab/calibrate/Campaign.h>
#include <grader/lab/calibrate/Subject.h>
#include <grader/pipeline/SpecScenes.h>

namespace ticker::calibrate {

/// Measures the misfit of pictures of the handout's scene (`dof.picture-differs`): for right
/// submissions, and for some mistakes that only a picture shows. A unit is a block of renders of
/// one subject, each with another seed.
class PictureCampaign final : public Campaign {
public:
    /// @param subjects  All subjects; the campaign uses the right ones whose pictures are compared,
    ///                  and some mistakes.
    /// @param scene     Option 2's scene.
    /// @param programs  Must outlive this object.
    PictureCampaign(const std::vector<Subject>& subjects, pipeline::SpecScene scene,
                    Programs& programs);

    [[nodiscard]] std::string name() const override { return "pictures"; }
    [[nodiscard]] std::size_t units() const override { return subjects_.size(); }
    [[nodiscard]] std::string unitName(std::size_t unit) const override {
        return subjects_.at(unit).name;
    }
    [[nodiscard]] Basis basisOf(std::size_t unit) const override;
    [[nodiscard]] std::vector<std::size_t> checkUnits() const override;
    [[nodiscard]] std::string run(std::size_t unit) override;
    [[nodiscard]] bool agrees(const std::string& before, const std::string& now) const override;
    [[nodiscard]] Summary summarise(const std::vector<std::string>& records) const override;

private:
    std::vector<Subject> subjects_;
    pipeline::SpecScene scene_;
    Programs& programs_;
};

}  // namespace ticker::calibrate

#endif
