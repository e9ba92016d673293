#ifndef TICKER_SELFTEST_ORACLEEXAMINEE_H
#define TICKER_SELFTEST_ORACLEEXAMINEE_H

#include <grader/oracle/Reading.h>
#include <grader/probe/Examinee.h>

#include <raytracer/base/RenderSettings.h>
#include <raytracer/scene/SceneDescription.h>

#include <vector>

namespace ticker::selftest {

/// A fast examinee that renders with the oracle, under any reading with any mistake. It answers
/// render questions only.
class OracleExaminee final : public probe::Examinee {
public:
    /// @param isPinhole  Renders as for option 1: one ray, hard shadows.
    OracleExaminee(const oracle::Reading& reading, const oracle::Mistake& mistake, bool isPinhole)
        : reading_(reading), mistake_(mistake), isPinhole_(isPinhole) {}

    [[nodiscard]] probe::Run ask(const std::vector<probe::Question>& questions) override;

    /// One render, linear, rows from the top.
    [[nodiscard]] std::vector<raytracer::ColourRGB> render(
        const raytracer::SceneDescription& scene, raytracer::RenderSettings settings) const;

private:
    oracle::Reading reading_;
    oracle::Mistake mistake_;
    bool isPinhole_;
};

}  // namespace ticker::selftest

#endif
