#ifndef TICKER_TASKS_DISTRIBUTED_PENUMBRASHARES_H
#define TICKER_TASKS_DISTRIBUTED_PENUMBRASHARES_H

#include <grader/tasks/shadows/answers/ShadowAims.h>
#include <grader/tasks/shadows/questions/PenumbraQuestion.h>
#include <grader/tasks/support/Surfaces.h>

#include <array>
#include <vector>

namespace ticker::tasks {

/// The light that got through at one place, call by call, as a share of all light.
struct PenumbraSamples {
    PenumbraQuestion::Place place;
    probe::LitPoint point;
    std::vector<double> shares;
    double mean = 0.0;
    double variance = 0.0;
};
[[nodiscard]] PenumbraSamples readSamples(const PenumbraQuestion& asked,
                                          const probe::IlluminateAnswer& answer,
                                          const PenumbraQuestion::Place& place);

/// Expected shares of one point under every reading of Phong, for one shape of the light.
struct ExpectedShares {
    double open = 0.0;                             ///< share of aims in sight
    std::array<std::array<double, 3>, 2> share{};  ///< [viewer is the eye][Phong]
};
/// @param size  Of the light, in units of lightSize.
[[nodiscard]] ExpectedShares expectedAt(const probe::IlluminateQuestion& asked,
                                        const Surfaces& surfaces, const probe::LitPoint& point,
                                        AimShape shape, double size);

/// The largest deviation of a mean (of each place, of all together, and of the pattern that another
/// size of the light makes), in units of what Bernstein's bound allows.
[[nodiscard]] double worstExcess(const std::vector<PenumbraSamples>& seen,
                                 const std::vector<double>& expected,
                                 const std::vector<double>& open);

}  // namespace ticker::tasks

#endif
