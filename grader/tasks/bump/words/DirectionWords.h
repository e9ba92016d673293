#ifndef TICKER_TASKS_BUMP_DIRECTIONWORDS_H
#define TICKER_TASKS_BUMP_DIRECTIONWORDS_H

#include <grader/tasks/bump/answers/Response.h>
#include <grader/tasks/bump/words/Phrases.h>

namespace ticker::tasks::bump {

/// What bump.wrong says of tilts in directions that fit no reading.
[[nodiscard]] Words directionWords(const Response& response);

/// What it says where many points are not tilted at all.
[[nodiscard]] Words patchyWords(const Response& response);

}  // namespace ticker::tasks::bump

#endif
