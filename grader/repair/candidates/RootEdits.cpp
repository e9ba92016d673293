// Both solutions of a quadratic equation where one was used.
#include <grader/repair/candidates/Atom.h>
#include <grader/repair/candidates/Scope.h>

#include <optional>

namespace ticker::candidates {
namespace {

constexpr const char* kKind = "root";

/// Whether an expression is a square root, or a variable that was given one.
bool isSquareRoot(const Tree& tree, int index) {
    const Node& node = tree.at(index);
    if (node.kind == NodeKind::name) {
        const int value = initialiserOf(tree, node);
        return value >= 0 && tree.at(value).kind == NodeKind::call && isSquareRoot(tree, value);
    }
    return node.kind == NodeKind::call && node.name == "sqrt";
}

/// The sum in `(-b - sqrt(d)) / (2 * a)` whose sign tells the two solutions apart, within an
/// expression; -1 if it has none.
int signedRootIn(const Tree& tree, int expression) {
    const Range& whole = tree.at(expression).range;
    for (int i = expression; i < static_cast<int>(tree.nodes.size()); ++i) {
        const Node& node = tree.at(i);
        if (!whole.holds(node.range)) break;
        if (node.kind == NodeKind::binary && (node.name == "+" || node.name == "-") &&
            isSquareRoot(tree, node.children.back()))
            return i;
    }
    return -1;
}

/// The same solution with the other sign; empty where an expression is no solution.
std::optional<std::string> otherSolution(const Edits& edits, int expression) {
    const Tree& tree = edits.tree();
    const int sum = signedRootIn(tree, expression);
    if (sum < 0) return std::nullopt;
    const Node& node = tree.at(sum);
    const Range& whole = tree.at(expression).range;
    const Range between{tree.at(node.children.front()).range.end,
                        tree.at(node.children.back()).range.begin};
    return applied(edits.text(expression), whole.begin,
                   {{between, node.name == "-" ? " + " : " - "}});
}

/// The visible variable with the other solution than this one has; -1 if there is no such variable.
int otherVariable(const Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const int value = initialiserOf(tree, tree.at(index));
    const auto wanted = value < 0 ? std::nullopt : otherSolution(edits, value);
    if (!wanted) return -1;
    for (const int variable : visibleVariables(tree, index)) {
        const Node& node = tree.at(variable);
        if (node.kind != NodeKind::declaration || node.children.empty()) continue;
        const auto other = otherSolution(edits, node.children.back());
        if (other && wordsOf(*wanted) == wordsOf(edits.text(node.children.back()))) return variable;
    }
    return -1;
}

std::string nearestInFront(const std::string& nearer, const std::string& farther) {
    return nearer + " > 0.0 ? " + nearer + " : " + farther;
}

/// Whether a value is used, and not only compared.
bool isUsed(const Tree& tree, int index) {
    const int parent = tree.at(index).parent;
    return parent >= 0 && !isComparison(tree.at(parent)) &&
           tree.at(parent).kind != NodeKind::function;
}

/// `std::min(near, far)`: the smaller one may be behind the ray.
void chooseInFront(Edits& edits, int index) {
    const Node& node = edits.tree().at(index);
    constexpr std::size_t kWithArguments = 3;
    if (node.kind != NodeKind::call || node.name != "min" || node.children.size() != kWithArguments)
        return;
    const int first = node.children[1];
    const int second = node.children[2];
    edits.replace(kKind, index, nearestInFront(edits.operand(first), edits.operand(second)), false);
    edits.replace(kKind, index, nearestInFront(edits.operand(second), edits.operand(first)), false);
}

/// `roots[0]` of two: the second one, if the first is behind the ray.
void chooseElement(Edits& edits, int index) {
    constexpr std::string_view kFirst = "[0]";
    const std::string text = edits.text(index);
    if (edits.tree().at(index).kind != NodeKind::expression || !text.ends_with(kFirst)) return;
    const std::string array = text.substr(0, text.size() - kFirst.size());
    edits.replace(kKind, index, nearestInFront(text, array + "[1]"), false);
}

}  // namespace

void addSecondRoots(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (!node.isExpression || !edits.isType(index, "double") || !isUsed(tree, index)) return;
    chooseInFront(edits, index);
    chooseElement(edits, index);
    if (node.kind == NodeKind::name) {
        const int other = otherVariable(edits, index);
        if (other >= 0)
            edits.replace(kKind, index, nearestInFront(node.name, tree.at(other).name), false);
    } else if (isGiven(tree, index)) {
        if (const auto other = otherSolution(edits, index))
            edits.replace(kKind, index, nearestInFront(edits.text(index), *other), false);
    }
}

}  // namespace ticker::candidates
