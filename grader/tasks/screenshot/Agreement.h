#ifndef TICKER_TASKS_SCREENSHOT_AGREEMENT_H
#define TICKER_TASKS_SCREENSHOT_AGREEMENT_H

#include <grader/metrics/NoiseEnergy.h>
#include <grader/tasks/screenshot/ShownScene.h>

#include <optional>

namespace ticker::tasks::screenshot {

/// Significance level of one stage. Two stages on different pixels must fail, so that an honest
/// picture fails with a chance of 2.5e-7.
inline constexpr double kSmallestChance = 5e-4;

/// Whether windows of a picture agree with one render by some code.
struct Agreement {
    bool agrees = false;
    bool isLossy = false;         ///< many pixels differ; if it agrees, only a little, as in a JPEG
    double rms = 0.0;             ///< root mean square of the difference, steps of a byte
    double differing = 0.0;       ///< for code without random rays: share of pixels that differ
    metrics::NoiseEnergy energy;  ///< for code with random rays
};

/// @param isRandom  Whether the code draws random rays, so that no two renders are equal. An honest
///                  picture then disagrees with a chance of 5e-4, even if it took more rays than
///                  ours.
[[nodiscard]] Agreement agreementOf(const ByteView& windows, const ByteView& own, bool isRandom);

/// Noise variance of a picture relative to another picture of the same scene: the median over the
/// noisy tiles. Empty if the other has hardly any noise.
[[nodiscard]] std::optional<double> noiseRatio(const ByteView& windows, const ByteView& own);

}  // namespace ticker::tasks::screenshot

#endif
