#ifndef TICKER_CALIBRATE_STALENESS_H
#define TICKER_CALIBRATE_STALENESS_H

#include <grader/lab/calibrate/Record.h>

#include <string>
#include <vector>

namespace ticker::calibrate {

/// Units of a record that were measured with other code than today's: a line for each set of parts
/// that have changed since, with the tasks or entries to repeat, the command, and the CPU time that
/// they took before. Empty if all units belong to today's code.
/// @param stamps  Of today's code, by unit.
[[nodiscard]] std::vector<std::string> stalenessOf(const Campaign& campaign, const Record& record,
                                                   const std::vector<Stamp>& stamps,
                                                   const Parts& parts);

}  // namespace ticker::calibrate

#endif
