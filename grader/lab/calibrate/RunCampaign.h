#ifndef TICKER_CALIBRATE_RUNCAMPAIGN_H
#define TICKER_CALIBRATE_RUNCAMPAIGN_H

#include <grader/lab/calibrate/Record.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace ticker::calibrate {

/// Called when a unit is finished, one call at a time.
using OnUnit = std::function<void(std::size_t done, std::size_t of)>;

/// Runs all units that are not in the record.
/// @param jobs  Number of threads.
/// @throws raytracer::Error of the first unit that could not be run; finished units stay in the
///         record.
void runCampaign(Campaign& campaign, Record& record, int jobs, const OnUnit& onUnit);

/// Repeats the campaign's check units and compares them with the record.
/// @return  One line for each unit that differs or is not in the record.
[[nodiscard]] std::vector<std::string> checkCampaign(Campaign& campaign, const Record& record,
                                                     int jobs);

}  // namespace ticker::calibrate

#endif
