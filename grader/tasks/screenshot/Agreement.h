#ifndef TICKER_TASKS_SCREENSHOT_AGREEMENT_H
#define TICKER_TASKS_SCREENSHOT_AGREEMENT_H

#include <grader/metrics/NoiseEnergy.h>
#include <grader/tasks/screenshot/Scene.h>

#include <optional>

namespace ticker::tasks::screenshot {

/// Two stages must fail, on other pixels, so that an honest picture fails with 2.5e-7.
inline constexpr double kSmallestChance = 5e-4;

/// Whether windows of a picture are what some code renders, which is known from one render.
struct Agreement {
    bool agrees = false;
    bool isLossy = false;         ///< agrees but for small errors everywhere, as JPEG makes them
    double rms = 0.0;             ///< root mean square of the difference, steps of a byte
    double differing = 0.0;       ///< where nothing is random: share of pixels that differ
    metrics::NoiseEnergy energy;  ///< where rays are random
};

/// @param isRandom  Whether the code draws rays at random, so that no two renders are equal. Then
///                  honest pictures agree but with a chance of 5e-4, also if they took more rays
///                  than ours.
[[nodiscard]] Agreement agreementOf(const ByteView& windows, const ByteView& own, bool isRandom);

/// How noisy a picture is beside another one of the same: the variance of its noise over that of
/// the other, in the middle one of all noisy tiles. Empty where the other has hardly any noise.
[[nodiscard]] std::optional<double> noiseRatio(const ByteView& windows, const ByteView& own);

}  // namespace ticker::tasks::screenshot

#endif
