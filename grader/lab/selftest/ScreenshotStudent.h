#ifndef TICKER_SELFTEST_SCREENSHOTSTUDENT_H
#define TICKER_SELFTEST_SCREENSHOTSTUDENT_H

#include <grader/metrics/PictureView.h>
#include <grader/pipeline/SpecScenes.h>
#include <grader/probe/Examinee.h>
#include <grader/result/SubmissionResult.h>

#include <cstdint>
#include <vector>

namespace ticker::selftest {

/// A simulated student who attempted one option: renders pictures, and hands some in.
class ScreenshotStudent {
public:
    /// @param scenes, code     Must outlive this object. The code is asked for its own pictures.
    /// @param isDeterministic  The student attempted option 1, whose pictures have no noise;
    ///                         otherwise option 2.
    ScreenshotStudent(const std::vector<pipeline::SpecScene>& scenes, bool isDeterministic,
                      probe::Examinee& code);

    /// The option's scene at the given width, rendered by its code.
    /// @param rays  Rays for each pixel; option 2.
    [[nodiscard]] metrics::Picture render(int width, std::uint64_t seed, int rays = 50) const;
    /// The same for any scene and shape.
    [[nodiscard]] metrics::Picture render(const pipeline::SpecScene& scene, int width, int height,
                                          std::uint64_t seed, int rays = 50) const;

    /// The grader's judgement of this picture together with the code.
    /// @param judgeMs  Set to the CPU time of this thread.
    [[nodiscard]] TaskJudgement handIn(const metrics::Picture& picture, std::uint64_t seed,
                                       double& judgeMs) const;

    /// The option's own scene.
    [[nodiscard]] const pipeline::SpecScene& scene() const { return *scene_; }

private:
    const std::vector<pipeline::SpecScene>& scenes_;
    bool isDeterministic_;
    probe::Examinee& code_;
    const pipeline::SpecScene* scene_ = nullptr;
    std::vector<pipeline::Rendered> own_;
};

}  // namespace ticker::selftest

#endif
