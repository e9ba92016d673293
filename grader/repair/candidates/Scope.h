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

/// The value that a variable was given where it was declared; -1: none.
[[nodiscard]] int initialiserOf(const Tree& tree, const Node& name);

/// Whether a node is all that a variable is given: its initialiser, or what is assigned to it.
[[nodiscard]] bool isGiven(const Tree& tree, int index);

/// Whether an expression asks for a random number: every use of it gets another one.
[[nodiscard]] bool draws(const Tree& tree, int expression);

/// The same, or whether a variable that it names was given a random number.
[[nodiscard]] bool dependsOnDraws(const Tree& tree, int expression);

/// Whether all names of an expression could be used at the place of a node.
[[nodiscard]] bool isUsableAt(const Tree& tree, int expression, int index);

}  // namespace ticker::candidates

#endif
