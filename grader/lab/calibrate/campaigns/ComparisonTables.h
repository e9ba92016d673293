#ifndef TICKER_CALIBRATE_COMPARISONTABLES_H
#define TICKER_CALIBRATE_COMPARISONTABLES_H

#include <grader/lab/calibrate/Campaign.h>

#include <string>
#include <vector>

namespace ticker::calibrate {

/// Rates of false failures and misses of each way of judging, and its errors, from the records of a
/// ComparisonCampaign. Ours is expected to have neither.
[[nodiscard]] Summary comparisonTables(const std::vector<std::string>& records);

}  // namespace ticker::calibrate

#endif
