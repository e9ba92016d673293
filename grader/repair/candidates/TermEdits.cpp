#include <grader/repair/candidates/Atom.h>
#include <grader/repair/candidates/Scope.h>

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace ticker::candidates {
namespace {

/// Expressions in a node's outermost function that satisfy a condition, one for each text, in the
/// order of the text; at most `most`.
template <class Wanted>
std::vector<int> expressionsLike(const Edits& edits, int index, std::size_t most, Wanted wanted) {
    const Tree& tree = edits.tree();
    int function = tree.functionOf(index);
    for (int outer = function; outer >= 0; outer = tree.functionOf(outer))
        function = outer;
    std::vector<int> found;
    if (function < 0) return found;
    std::set<std::string> known;
    for (int i = function; i < static_cast<int>(tree.nodes.size()) && found.size() < most; ++i) {
        if (!tree.at(function).range.holds(tree.at(i).range)) break;
        if (wanted(i) && known.insert(edits.text(i)).second) found.push_back(i);
    }
    return found;
}

/// Whether a node is a number that an object or a call supplies: `map.width()`, `settings().rays`.
bool isQuantity(const Edits& edits, int i) {
    const Node& node = edits.tree().at(i);
    if (!node.isExpression || !edits.isNumber(i)) return false;
    if (node.kind == NodeKind::call) return node.children.size() == 1 && node.name != "operator()";
    return node.kind == NodeKind::member && !node.children.empty() &&
           edits.tree().at(node.children.front()).kind == NodeKind::call;
}

/// Whether a node is a variable that was given such a number: `const int w = map.width();`.
bool isKeptSize(const Edits& edits, int i) {
    const Node& node = edits.tree().at(i);
    if (node.kind != NodeKind::name || !edits.isInteger(i) || node.declared == 0) return false;
    return std::ranges::any_of(edits.tree().nodes, [&](const Node& one) {
        return one.kind == NodeKind::declaration && one.declared == node.declared &&
               !one.children.empty() && isQuantity(edits, one.children.back());
    });
}

bool standsBefore(const Edits& edits, int declarationOrUse, int index) {
    return edits.tree().at(declarationOrUse).range.end <= edits.tree().at(index).range.begin;
}

/// Variables of a type that an earlier part of the function uses.
std::vector<int> usedBefore(const Edits& edits, int index, std::string_view type,
                            std::size_t most) {
    return expressionsLike(edits, index, most, [&](int i) {
        const Node& node = edits.tree().at(i);
        return node.kind == NodeKind::name && node.type == type && node.declared != 0 &&
               standsBefore(edits, i, index);
    });
}

void addBounds(Edits& edits, int index) {
    // Bounds an index that may lie outside, by sizes that the same function names.
    const Node& around = edits.tree().at(edits.tree().at(index).parent);
    if (!edits.isInteger(index) || around.kind != NodeKind::declaration) return;
    const auto sizes = expressionsLike(
        edits, index, 6, [&](int i) { return edits.isInteger(i) && isQuantity(edits, i); });
    for (const int size : sizes) {
        if (!isUsableAt(edits.tree(), size, index)) continue;
        const std::string bound = edits.text(size);
        edits.replace("bound", index, edits.operand(index) + " % " + bound, false);
        edits.replace("bound", index, "std::min(" + edits.text(index) + ", " + bound + " - 1)",
                      true);
        edits.replace("bound", index, "std::clamp(" + edits.text(index) + ", 0, " + bound + " - 1)",
                      true);
        edits.replace("bound", index, "(" + edits.operand(index) + " + " + bound + ") % " + bound,
                      true);
    }
}

/// Whether a node is a whole initialiser or value, an argument, or all that stands in parentheses,
/// as in `(a - b).normalised()`.
bool isWhole(const Tree& tree, int index) {
    const Node& node = tree.at(index);
    if (node.parent < 0) return false;
    const Node& around = tree.at(node.parent);
    if (!around.isExpression || around.kind == NodeKind::parentheses) return true;
    return around.kind == NodeKind::call && around.children.front() != index;
}

/// The letter of the axis that is neither of both, where these are two of x, y and z; else 0.
char thirdAxis(char one, char other) {
    const std::string both{one, other};
    for (const auto& [pair, third] : {std::pair{"xy", 'z'}, {"yz", 'x'}, {"xz", 'y'}})
        if (both == pair || (both[0] == pair[1] && both[1] == pair[0])) return third;
    return 0;
}

/// The term for the third axis if two terms differ only in the letters of two axes: `z * z` for `x
/// * x` and `y * y`. Empty if they differ otherwise.
std::string alongThirdAxis(std::string_view one, std::string_view other) {
    std::string term{one};
    if (one.size() != other.size()) return {};
    for (std::size_t i = 0; i < one.size(); ++i) {
        if (one[i] == other[i]) continue;
        const char third = thirdAxis(one[i], other[i]);
        if (third == 0) return {};
        term[i] = third;
    }
    return term == one ? std::string{} : term;
}

/// Adds the missing third term to a sum over two axes, such as a squared length or a dot product.
void completeAxes(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (node.kind != NodeKind::binary || node.name != "+" || !edits.isType(index, "double")) return;
    const std::string third =
        alongThirdAxis(edits.text(node.children[0]), edits.text(node.children[1]));
    if (third.empty()) return;
    edits.add("term", index, {{{node.range.end, node.range.end}, " + " + third}});
}

}  // namespace

void addNeighbours(Edits& edits, int index) {
    // Replaces an index by that of its neighbour, which wraps at the edge or is clamped to it.
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (node.kind != NodeKind::name || !edits.isInteger(index) || node.parent < 0) return;
    const Node& around = tree.at(node.parent);
    if (around.kind != NodeKind::call || around.children.front() == index) return;
    const auto sizes = expressionsLike(edits, index, 4, [&](int i) {
        return edits.isInteger(i) && (isQuantity(edits, i) || isKeptSize(edits, i));
    });
    const std::string at = edits.text(index);
    for (const int size : sizes) {
        const std::string bound = edits.text(size);
        if (bound == at || !isUsableAt(tree, size, index)) continue;
        edits.replace("neighbour", index, "(" + at + " + 1) % " + bound, false);
        edits.replace("neighbour", index, "(" + at + " + " + bound + " - 1) % " + bound, false);
        edits.replace("neighbour", index, "std::min(" + at + " + 1, " + bound + " - 1)", true);
    }
    if (!sizes.empty()) edits.replace("neighbour", index, "std::max(" + at + " - 1, 0)", true);
}

void addTermEdits(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    completeAxes(edits, index);
    if (!node.isExpression || node.kind == NodeKind::parentheses || !isWhole(tree, index)) return;
    addBounds(edits, index);
    constexpr std::size_t kMost = 6;
    if (edits.isVector(index) && node.kind != NodeKind::name)
        for (const int variable : usedBefore(edits, index, node.type, kMost)) {
            const std::string name = edits.text(variable);
            edits.replace("term", index, name + " + " + edits.text(index), false);
            edits.replace("term", index, name + " - " + edits.operand(index), false);
        }
    if (!edits.isVector(index) && !edits.isType(index, "double")) return;
    std::vector<int> factors =
        expressionsLike(edits, index, kMost, [&](int i) { return isQuantity(edits, i); });
    if (edits.isVector(index))
        for (const int variable : usedBefore(edits, index, "double", kMost))
            factors.push_back(variable);
    for (const int factor : factors) {
        if (!isUsableAt(tree, factor, index)) continue;
        edits.replace("factor", index, edits.operand(index) + " * " + edits.text(factor), false);
        edits.replace("factor", index, edits.operand(index) + " / " + edits.text(factor), false);
    }
}

void addSiblingEdits(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (!node.isExpression || node.kind == NodeKind::parentheses || isCounting(node)) return;
    if (!edits.isNumber(index) && !edits.isVector(index)) return;
    constexpr std::size_t kMostTokens = 14;
    constexpr std::size_t kMost = 8;
    if (edits.source().tokensIn(node.range).size() > kMostTokens) return;
    const bool isSimple = node.kind == NodeKind::number || node.kind == NodeKind::name;
    const auto others = expressionsLike(edits, index, kMost, [&](int i) {
        const Node& other = tree.at(i);
        if (!other.isExpression || other.type != node.type || other.range.holds(node.range) ||
            node.range.holds(other.range))
            return false;
        if (isQuantity(edits, i)) return true;
        const bool isNear = tree.statementOf(i) == tree.statementOf(index);
        return !isSimple && isNear &&
               (other.kind == NodeKind::call || other.kind == NodeKind::binary);
    });
    for (const int other : others)
        if (isUsableAt(tree, other, index)) edits.replaceBy("sibling", index, other);
}

}  // namespace ticker::candidates
