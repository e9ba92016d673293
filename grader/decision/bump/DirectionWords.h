#ifndef TICKER_DECISION_BUMP_DIRECTIONWORDS_H
#define TICKER_DECISION_BUMP_DIRECTIONWORDS_H

#include <grader/decision/bump/Phrases.h>
#include <grader/decision/bump/Response.h>

namespace ticker::decision::bump {

/// What bump.wrong says of tilts in directions that fit no reading.
[[nodiscard]] Words directionWords(const Response& response);

/// What it says where many points are not tilted at all.
[[nodiscard]] Words patchyWords(const Response& response);

}  // namespace ticker::decision::bump

#endif
