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

/// Whether a node, or one inside of it, is as asked.
template <typename IsAsked>
bool anyIn(const Tree& tree, int expression, const IsAsked& isAsked) {
    const Range& whole = tree.at(expression).range;
    for (int i = expression; i < static_cast<int>(tree.nodes.size()); ++i) {
        if (!whole.holds(tree.at(i).range)) return false;
        if (isAsked(tree.at(i))) return true;
    }
    return false;
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

int initialiserOf(const Tree& tree, const Node& name) {
    for (const Node& node : tree.nodes)
        if (node.kind == NodeKind::declaration && node.declared == name.declared &&
            !node.children.empty())
            return node.children.back();
    return -1;
}

bool isGiven(const Tree& tree, int index) {
    const Node& node = tree.at(index);
    if (!node.isExpression || node.parent < 0) return false;
    const Node& around = tree.at(node.parent);
    return (around.kind == NodeKind::declaration ||
            (around.kind == NodeKind::binary && around.name == "=")) &&
           around.children.back() == index;
}

bool draws(const Tree& tree, int expression) {
    return anyIn(tree, expression, [](const Node& node) {
        const bool isNamed = node.kind == NodeKind::call && node.name.starts_with("rand");
        return isNamed || node.name == "operator()";
    });
}

bool dependsOnDraws(const Tree& tree, int expression) {
    return draws(tree, expression) || anyIn(tree, expression, [&](const Node& node) {
               if (node.kind != NodeKind::name || node.declared == 0) return false;
               const int value = initialiserOf(tree, node);
               return value >= 0 && draws(tree, value);
           });
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
