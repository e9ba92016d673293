#ifndef TICKER_CALIBRATE_RUNCAMPAIGN_H
#define TICKER_CALIBRATE_RUNCAMPAIGN_H

#include <grader/lab/calibrate/Record.h>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace ticker::calibrate {

/// Called when a unit is finished, one call at a time.
using OnUnit = std::function<void(std::size_t done, std::size_t of)>;

/// The code that each unit's result depends on today.
[[nodiscard]] std::vector<Stamp> stampsOf(const Campaign& campaign, const Parts& parts);

/// Runs all units that the record lacks, or that were measured with other code.
/// @param stamps  Today's, one for each unit.
/// @param part    Only units whose name contains it are run; empty: all.
/// @param jobs    Number of threads.
/// @throws raytracer::Error of the first unit that could not be run; finished units stay in the
///         record.
void runCampaign(Campaign& campaign, Record& record, const std::vector<Stamp>& stamps, int jobs,
                 const OnUnit& onUnit, std::string_view part = {});

/// Number of units in the record that were measured with today's code.
[[nodiscard]] std::size_t currentUnits(const Record& record, const std::vector<Stamp>& stamps);

/// Repeats the campaign's check units and compares them with the record.
/// @return  One line for each unit that differs or is not in the record.
[[nodiscard]] std::vector<std::string> checkCampaign(Campaign& campaign, const Record& record,
                                                     int jobs);

}  // namespace ticker::calibrate

#endif
