#ifndef TICKER_CALIBRATE_COMPARISONCAMPAIGN_H
#define TICKER_CALIBRATE_COMPARISONCAMPAIGN_H

#include <grader/lab/calibrate/Campaign.h>
#include <grader/lab/calibrate/Subject.h>
#include <grader/lab/calibrate/campaigns/PictureMethods.h>

#include <memory>
#include <mutex>

namespace ticker::calibrate {

/// Compares our decision with other ways of judging on the same submissions. Each submission
/// renders the handout's scene once, at 160 x 120. A unit is one subject.
class ComparisonCampaign final : public Campaign {
public:
    /// @param scene     The rendered scene.
    /// @param programs  Must outlive this object.
    ComparisonCampaign(std::vector<Subject> subjects, raytracer::SceneDescription scene,
                       Programs& programs);

    [[nodiscard]] std::string name() const override { return "comparison"; }
    [[nodiscard]] std::size_t units() const override { return subjects_.size(); }
    [[nodiscard]] std::string unitName(std::size_t unit) const override {
        return subjects_.at(unit).name;
    }
    [[nodiscard]] Basis basisOf(std::size_t unit) const override;
    [[nodiscard]] std::vector<std::size_t> checkUnits() const override;
    [[nodiscard]] std::string run(std::size_t unit) override;
    /// Pictures differ in their last digits between processors: scores may differ by a hundredth.
    [[nodiscard]] bool agrees(const std::string& before, const std::string& now) const override;
    [[nodiscard]] Summary summarise(const std::vector<std::string>& records) const override;

private:
    const PictureMethods& methods();

    std::vector<Subject> subjects_;
    raytracer::SceneDescription scene_;
    Programs& programs_;
    std::once_flag once_;
    std::unique_ptr<PictureMethods> methods_;
};

}  // namespace ticker::calibrate

#endif
