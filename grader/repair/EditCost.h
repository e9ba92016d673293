#ifndef TICKER_REPAIR_EDITCOST_H
#define TICKER_REPAIR_EDITCOST_H

#include <grader/repair/Candidates.h>
#include <grader/repair/SwitchedProgram.h>

#include <cstddef>
#include <string_view>
#include <vector>

namespace ticker::repair {

/// Words and operators that a set of edits takes away and puts in: the fewer, the simpler the
/// repair.
[[nodiscard]] std::size_t tokensChanged(std::string_view source, const Candidates& candidates,
                                        const EditSet& set);

/// Sets in the order in which they are tried: those that change the fewest tokens first.
/// @param isOne  Each set counts as one edit at several places: it costs as much as its costliest
///               edit.
[[nodiscard]] std::vector<EditSet> simplestFirst(std::string_view source,
                                                 const Candidates& candidates,
                                                 std::vector<EditSet> sets, bool isOne = false);

}  // namespace ticker::repair

#endif
