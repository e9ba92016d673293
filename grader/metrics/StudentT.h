#ifndef TICKER_METRICS_STUDENTT_H
#define TICKER_METRICS_STUDENTT_H

namespace ticker::metrics {

/// P(|T| >= |t|) of Student's distribution, accurate far out in the tails; NaN for NaN.
/// @param degrees  Degrees of freedom, above 0; need not be an integer.
[[nodiscard]] double twoSidedTail(double t, double degrees);

}  // namespace ticker::metrics

#endif
