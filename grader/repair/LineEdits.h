#ifndef TICKER_REPAIR_LINEEDITS_H
#define TICKER_REPAIR_LINEEDITS_H

#include <grader/repair/Candidates.h>
#include <grader/result/Repair.h>

#include <string_view>
#include <vector>

namespace ticker::repair {

/// Edits as people read them: the whole lines that they change, before and after, as cleanText
/// makes them and without the carriage return of their end.
[[nodiscard]] std::vector<RepairEdit> lineEdits(std::string_view source,
                                                const std::vector<TextEdit>& edits);

}  // namespace ticker::repair

#endif
