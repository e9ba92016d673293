#ifndef TICKER_TASKS_BUMP_DIRECTIONWORDS_H
#define TICKER_TASKS_BUMP_DIRECTIONWORDS_H

#include <grader/tasks/bump/Examination.h>
#include <grader/tasks/bump/words/Phrases.h>

#include <optional>

namespace ticker::tasks::bump {

/// Words of bump.wrong for tilts whose direction fits no reading.
[[nodiscard]] Words directionWords(const Response& response,
                                   const std::optional<Hints>& hints = {});

/// Words of bump.wrong if many points are not tilted at all.
[[nodiscard]] Words patchyWords(const Response& response);

}  // namespace ticker::tasks::bump

#endif
