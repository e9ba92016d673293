#include <grader/repair/candidates/Scope.h>

#include <algorithm>

namespace ticker::candidates {
namespace {

bool isVariable(const Node& node) {
    return node.declared != 0 && !node.isExpression && !node.name.empty();
}

/// Whether a declaration has ended before a node, and the block around it holds the node.
bool isVisible(const Tree& tree, int declaration, int index) {
    if (tree.at(declaration).range.end > tree.at(index).range.begin) return false;
    int block = tree.at(declaration).parent;
    while (block >= 0 && tree.at(block).kind != NodeKind::block &&
           tree.at(block).kind != NodeKind::function && tree.at(block).kind != NodeKind::loop)
        block = tree.at(block).parent;
    return block < 0 || tree.at(block).range.holds(tree.at(index).range);
}

}  // namespace

int outermostFunction(const Tree& tree, int index) {
    int outermost = -1;
    for (int around = tree.functionOf(index); around >= 0; around = tree.functionOf(around))
        outermost = around;
    return outermost;
}

std::vector<int> visibleVariables(const Tree& tree, int index) {
    std::vector<int> found;
    for (int i = std::max(0, outermostFunction(tree, index)); i < index; ++i)
        if (isVariable(tree.at(i)) && isVisible(tree, i, index)) found.push_back(i);
    return found;
}

bool isUsableAt(const Tree& tree, int expression, int index) {
    for (int i = expression; i < static_cast<int>(tree.nodes.size()); ++i) {
        const Node& node = tree.at(i);
        if (!tree.at(expression).range.holds(node.range)) break;
        if (node.kind != NodeKind::name || node.declared == 0) continue;
        const auto declaration = std::ranges::find_if(tree.nodes, [&](const Node& one) {
            return isVariable(one) && one.declared == node.declared;
        });
        if (declaration == tree.nodes.end()) continue;
        const auto at = static_cast<int>(declaration - tree.nodes.begin());
        const bool isInside = tree.at(expression).range.holds(declaration->range);
        if (!isInside && !isVisible(tree, at, index)) return false;
    }
    return true;
}

}  // namespace ticker::candidates
