#ifndef TICKER_REPAIR_CANDIDATES_SCOPE_H
#define TICKER_REPAIR_CANDIDATES_SCOPE_H

#include <grader/repair/candidates/Tree.h>

#include <vector>

namespace ticker::candidates {

/// The function that all others around a node stand in; -1: none.
[[nodiscard]] int outermostFunction(const Tree& tree, int index);

/// Variables and parameters that a node can name, in the order of the text. What the node's own
/// statement declares is left out.
[[nodiscard]] std::vector<int> visibleVariables(const Tree& tree, int index);

/// Whether all names of an expression could be used at the place of a node.
[[nodiscard]] bool isUsableAt(const Tree& tree, int expression, int index);

}  // namespace ticker::candidates

#endif
