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

/// Does all units that the record does not have yet.
/// @param jobs  Threads.
/// @throws raytracer::Error of the first unit that could not be done; what is finished is kept.
void runCampaign(Campaign& campaign, Record& record, int jobs, const OnUnit& onUnit);

/// Does the campaign's check units again and compares with the record.
/// @return  One line for each unit that came out differently, or that the record does not have.
[[nodiscard]] std::vector<std::string> checkCampaign(Campaign& campaign, const Record& record,
                                                     int jobs);

}  // namespace ticker::calibrate

#endif
