#ifndef TICKER_TASKS_SHADOWS_PENUMBRA_PENUMBRASHARES_H
#define TICKER_TASKS_SHADOWS_PENUMBRA_PENUMBRASHARES_H

#include <grader/tasks/shadows/answers/ShadowAims.h>
#include <grader/tasks/shadows/penumbra/PenumbraQuestion.h>
#include <grader/tasks/support/Surfaces.h>

#include <array>
#include <vector>

namespace ticker::tasks {

/// Share of the light that arrives at one place, for each call.
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

/// Expected shares of one point under every Phong reading, for one shape of the light.
struct ExpectedShares {
    /// One Phong term for the centre of the light or one for each aim; each with the falloff of the
    /// centre's distance, of the aim's, or of the nearest point of the light on the aim's line, as
    /// sampling of the light's solid angle gives it. Index 0: central, with the centre's distance.
    static constexpr std::size_t kPhongReadings = 6;
    /// Whether a reading has the falloff of the nearest points.
    [[nodiscard]] static constexpr bool isNearSide(std::size_t phong) { return phong % 3 == 2; }

    double open = 0.0;                                          ///< share of aims in sight
    std::array<std::array<double, kPhongReadings>, 2> share{};  ///< [viewer is the eye][Phong]
};
/// @param size  Radius of the light in units of lightSize.
[[nodiscard]] ExpectedShares expectedAt(const probe::IlluminateQuestion& asked,
                                        const Surfaces& surfaces, const probe::LitPoint& point,
                                        AimShape shape, double size);

/// The largest deviation of a mean, in units of Bernstein's bound. Tested are the mean of each
/// place, the mean of all, and the pattern of a light of another size.
[[nodiscard]] double worstExcess(const std::vector<PenumbraSamples>& seen,
                                 const std::vector<double>& expected,
                                 const std::vector<double>& open);

}  // namespace ticker::tasks

#endif
