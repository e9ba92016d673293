#ifndef TICKER_CALIBRATE_STALENESS_H
#define TICKER_CALIBRATE_STALENESS_H

#include <grader/lab/calibrate/Record.h>

#include <string>
#include <vector>

namespace ticker::calibrate {

/// Which units of a record are of other code than today's: a line for each set of parts that have
/// changed since, with the tasks or entries to repeat, the command, and the CPU time that it took
/// before. Empty if the record is of today's code.
/// @param stamps  Of today's code, by unit.
[[nodiscard]] std::vector<std::string> stalenessOf(const Campaign& campaign, const Record& record,
                                                   const std::vector<Stamp>& stamps,
                                                   const Parts& parts);

}  // namespace ticker::calibrate

#endif
