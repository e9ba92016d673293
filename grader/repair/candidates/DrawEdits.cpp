#include <grader/repair/candidates/Atom.h>
#include <grader/repair/candidates/Scope.h>

namespace ticker::candidates {
namespace {

bool isSumOfTwo(const Node& node) {
    return node.kind == NodeKind::binary && (node.name == "+" || node.name == "-");
}

bool isProductOfTwo(const Node& node) {
    return node.kind == NodeKind::binary && (node.name == "*" || node.name == "/");
}

/// Rewrites `(a + b + c) * s` as `a + (b + c) * s` and as `a + b + c * s`.
/// @param sum  The sum in the parentheses.
void takeTermsOut(Edits& edits, int product, int sum) {
    const Tree& tree = edits.tree();
    const std::size_t end = tree.at(sum).range.end;
    const std::string scale =
        " " + tree.at(product).name + " " + edits.text(tree.at(product).children[1]);
    for (int at = sum; isSumOfTwo(tree.at(at)); at = tree.at(at).children.front()) {
        const Node& node = tree.at(at);
        const std::size_t begin = tree.at(node.children[1]).range.begin;
        const std::string inner = at == sum
                                      ? edits.operand(node.children[1])
                                      : "(" + std::string{edits.source().in({begin, end})} + ")";
        edits.replace("regroup", product,
                      edits.text(node.children[0]) + " " + node.name + " " + inner + scale, false);
    }
}

}  // namespace

void addDrawEdits(Edits& edits, int index) {
    // Gives a place that uses a shared random number a new one, by the variable's initialiser.
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (node.kind != NodeKind::name || node.declared == 0) return;
    const bool isRead = node.parent >= 0 && !isCounting(tree.at(node.parent));
    if (!isRead || (!edits.isNumber(index) && !edits.isVector(index))) return;
    const int value = initialiserOf(tree, node);
    if (value < 0 || !tree.at(value).isExpression || !draws(tree, value)) return;
    if (isUsableAt(tree, value, index)) edits.replaceBy("draw", index, value);
}

void addGroupingEdits(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (node.kind != NodeKind::binary || !(edits.isType(index, "double") || edits.isVector(index)))
        return;
    const Node& left = tree.at(node.children[0]);
    const Node& right = tree.at(node.children[1]);
    const auto text = [&](int child) { return edits.text(child); };
    if (isSumOfTwo(node) && isProductOfTwo(right))
        edits.replace("regroup", index,
                      "(" + text(node.children[0]) + " " + node.name + " " +
                          text(right.children[0]) + ") " + right.name + " " +
                          text(right.children[1]),
                      false);
    if (!isProductOfTwo(node) || left.kind != NodeKind::parentheses || left.children.size() != 1)
        return;
    takeTermsOut(edits, index, left.children.front());
}

}  // namespace ticker::candidates
