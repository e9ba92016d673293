#ifndef TICKER_REPAIR_CANDIDATES_WIDETERMS_H
#define TICKER_REPAIR_CANDIDATES_WIDETERMS_H

#include <grader/repair/candidates/Atom.h>
#include <grader/repair/candidates/Vocabulary.h>

namespace ticker::candidates {

/// Whether a node is a whole initialiser, value, argument or item of a list, or all that stands in
/// parentheses.
[[nodiscard]] bool standsAlone(const Tree& tree, int index);

/// Terms and values that a function could name beside those of a node.
void addWideTerms(Edits& edits, int index, const Vocabulary& words);

/// Adds the edits of WideTerms.cpp for code that tests or uses a hit.
void addHitEdits(Edits& edits, int index);

}  // namespace ticker::candidates

#endif
