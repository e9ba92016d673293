#include <grader/repair/candidates/Atom.h>

#include <array>
#include <span>

namespace ticker::candidates {
namespace {

struct Exchange {
    std::string_view from;
    std::string_view to;
};

constexpr std::array kOperators{
    Exchange{"+", "-"},   Exchange{"-", "+"},   Exchange{"*", "/"},   Exchange{"/", "*"},
    Exchange{"<", "<="},  Exchange{"<", ">"},   Exchange{">", ">="},  Exchange{">", "<"},
    Exchange{"<=", "<"},  Exchange{"<=", ">="}, Exchange{">=", ">"},  Exchange{">=", "<="},
    Exchange{"<=", "=="}, Exchange{">=", "=="}, Exchange{"==", "!="}, Exchange{"!=", "=="},
    Exchange{"&&", "||"}, Exchange{"||", "&&"}, Exchange{"+=", "-="}, Exchange{"-=", "+="},
    Exchange{"=", "+="},  Exchange{"+=", "="}};

bool isOneOf(std::string_view name, std::initializer_list<std::string_view> names) {
    for (const std::string_view one : names)
        if (one == name) return true;
    return false;
}

bool isSum(const Node& node) {
    return node.kind == NodeKind::binary && isOneOf(node.name, {"+", "-"});
}

Range operatorOf(const Edits& edits, const Node& node) {
    const Tree& tree = edits.tree();
    return edits.source()
        .tokensIn({tree.at(node.children[0]).range.end, tree.at(node.children[1]).range.begin})
        .front();
}

/// All signs of a sum of three terms or more at once: `N - u - v` for `N + u + v`. Two edits of one
/// sum cannot be switched one by one, since one of them stands inside of the other.
void turnSigns(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const int around = tree.at(index).parent;
    const bool isWhole =
        around < 0 || !isSum(tree.at(around)) || tree.at(around).children.front() != index;
    if (!isWhole) return;
    std::vector<Replacement> signs;
    for (int at = index; isSum(tree.at(at)); at = tree.at(at).children.front())
        signs.push_back({operatorOf(edits, tree.at(at)), tree.at(at).name == "+" ? "-" : "+"});
    if (signs.size() >= 2) edits.add("operator", index, std::move(signs));
}

/// Whether a condition is `x == a || x == b`: both at once is never true.
bool askForTwoValues(const Edits& edits, const Node& node) {
    const Node& left = edits.tree().at(node.children[0]);
    const Node& right = edits.tree().at(node.children[1]);
    return left.name == "==" && right.name == "==" &&
           edits.text(left.children.front()) == edits.text(right.children.front());
}

/// `(a < 0) != (b < 0)`, with parentheses only where a side is a comparison.
std::vector<Replacement> asOneOfBoth(const Edits& edits, const Node& either, const Range& sign) {
    std::vector<Replacement> all{{sign, "!="}};
    for (const int side : either.children)
        if (const std::string text = edits.operand(side); text != edits.text(side))
            all.push_back({edits.tree().at(side).range, text});
    return all;
}

void dropOneSide(Edits& edits, int index, const Node& node) {
    const int left = node.children[0];
    const int right = node.children[1];
    if (!isOneOf(node.name, {"+", "-", "*", "/", "%", "&&", "||", "&", "|", "<<", ">>"})) return;
    edits.replaceBy("drop", index, left);
    if (isOneOf(node.name, {"/", "%", "<<", ">>"})) return;
    edits.replaceBy("drop", index, right);
    if (node.name == "-") edits.replace("drop", index, "-" + edits.operand(right), false);
}

/// `a % n` for `a & (n - 1)`, which is a modulo for powers of two alone.
void divideByAnyNumber(Edits& edits, int index, const Node& node, const Range& sign) {
    const Tree& tree = edits.tree();
    int mask = node.children[1];
    while (tree.at(mask).kind == NodeKind::parentheses && !tree.at(mask).children.empty())
        mask = tree.at(mask).children.front();
    const Node& difference = tree.at(mask);
    if (node.name != "&" || difference.kind != NodeKind::binary || difference.name != "-" ||
        edits.text(difference.children[1]) != "1")
        return;
    edits.add(
        "operator", index,
        {{sign, "%"}, {tree.at(node.children[1]).range, edits.operand(difference.children[0])}});
}

void editBinary(Edits& edits, int index, const Node& node) {
    const Tree& tree = edits.tree();
    const int left = node.children[0];
    const int right = node.children[1];
    const Range sign = operatorOf(edits, node);
    for (const Exchange& exchange : kOperators)
        if (node.name == exchange.from && !(exchange.to == "&&" && askForTwoValues(edits, node)))
            edits.add("operator", index, {{sign, std::string{exchange.to}}});
    // One of both, not both.
    if (node.name == "||" && edits.isType(left, "bool") && edits.isType(right, "bool") &&
        !askForTwoValues(edits, node))
        edits.add("operator", index, asOneOfBoth(edits, node, sign));
    if (isSum(node)) turnSigns(edits, index);
    divideByAnyNumber(edits, index, node, sign);
    dropOneSide(edits, index, node);
    if (isOneOf(node.name, {"-", "/"}))
        edits.add("exchange", index,
                  {{tree.at(left).range, edits.operand(right)},
                   {tree.at(right).range, edits.operand(left)}});
    // The sign of a sum's first term.
    const bool isFirst =
        isSum(node) && !isSum(tree.at(left)) && (edits.isNumber(left) || edits.isVector(left));
    if (isFirst && tree.at(left).kind != NodeKind::number)
        edits.add("sign", index, {{{tree.at(left).range.begin, tree.at(left).range.begin}, "-"}});
    if (node.name == "/" && edits.isInteger(left) && edits.isInteger(right))
        edits.add("cast", index,
                  {{tree.at(left).range, "static_cast<double>(" + edits.bareText(left) + ")"}});
}

}  // namespace

void addOperatorEdits(Edits& edits, int index) {
    const Node& node = edits.tree().at(index);
    if (node.kind == NodeKind::binary) editBinary(edits, index, node);
    if (node.kind == NodeKind::unary && isOneOf(node.name, {"-", "!"}) && !node.children.empty())
        edits.replaceBy("sign", index, node.children.front());
    if (node.kind == NodeKind::expression && node.children.size() == 3 &&
        edits.text(index).find('?') != std::string::npos) {
        const int first = node.children[1];
        const int second = node.children[2];
        edits.replaceBy("drop", index, first);
        edits.replaceBy("drop", index, second);
        edits.add("exchange", index,
                  {{edits.tree().at(first).range, edits.text(second)},
                   {edits.tree().at(second).range, edits.text(first)}});
    }
}

}  // namespace ticker::candidates
