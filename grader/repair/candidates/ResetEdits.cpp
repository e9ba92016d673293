#include <grader/repair/candidates/Atom.h>
#include <grader/repair/candidates/Scope.h>

#include <algorithm>

namespace ticker::candidates {
namespace {

/// Whether an expression adds something to a variable, or counts it.
bool addsTo(const Tree& tree, const Node& expression, const Node& variable) {
    const bool adds =
        expression.kind == NodeKind::binary && (expression.name == "+=" || expression.name == "-=");
    if (!adds && !isCounting(expression)) return false;
    const Node& changed = tree.at(expression.children.front());
    return changed.kind == NodeKind::name && changed.declared == variable.declared;
}

bool isAddedToIn(const Tree& tree, int block, const Node& variable) {
    for (int i = block; i < static_cast<int>(tree.nodes.size()); ++i) {
        if (!tree.at(block).range.holds(tree.at(i).range)) break;
        if (!tree.at(i).children.empty() && addsTo(tree, tree.at(i), variable)) return true;
    }
    return false;
}

/// Whether a block is gone through again and again: the body of a loop or of a lambda.
bool isRepeated(const Tree& tree, int block) {
    const int around = tree.at(block).parent;
    if (around < 0 || tree.at(around).children.back() != block) return false;
    const NodeKind kind = tree.at(around).kind;
    return kind == NodeKind::loop || (kind == NodeKind::function && tree.functionOf(around) >= 0);
}

bool isNumber(const Node& variable) {
    return variable.type == "int" || variable.type == "double";
}

bool mayHoldASum(const Node& variable) {
    return isNumber(variable) || variable.type == "raytracer::ColourRGB" ||
           variable.type == "raytracer::Vector3";
}

/// Sets the initial value of a sum to 0, as where it begins with the colour of an extra ray.
void beginWithNothing(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& sum = tree.at(index);
    if (!mayHoldASum(sum) || sum.children.empty() || sum.parent < 0) return;
    const int value = sum.children.back();
    const Node& given = tree.at(value);
    const int block = tree.at(tree.statementOf(index)).parent;
    if (!given.isExpression || given.kind == NodeKind::number || given.kind == NodeKind::list ||
        block < 0 || !isAddedToIn(tree, block, sum))
        return;
    const bool isColour = sum.type == "raytracer::ColourRGB";
    edits.replace("reset", value,
                  isNumber(sum) ? "0"
                  : isColour    ? "ColourRGB{}"
                                : "Vector3{}",
                  true);
}

}  // namespace

// Resets a sum or count that goes on from one light or pixel to the next.
void addResets(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (node.kind == NodeKind::declaration) beginWithNothing(edits, index);
    if (node.kind != NodeKind::block || node.children.empty() || !isRepeated(tree, index)) return;
    const int first = node.children.front();
    const std::size_t at = tree.at(first).range.begin;
    for (const int variable : visibleVariables(tree, first)) {
        const Node& sum = tree.at(variable);
        if (mayHoldASum(sum) && isAddedToIn(tree, index, sum))
            edits.addBefore("reset", first, {at, at},
                            sum.name + (isNumber(sum) ? " = 0;\n    " : " = {};\n    "));
    }
}

}  // namespace ticker::candidates
