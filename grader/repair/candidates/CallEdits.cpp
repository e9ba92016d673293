#include <grader/repair/candidates/Atom.h>
#include <grader/repair/candidates/Scope.h>

#include <algorithm>
#include <array>
#include <optional>

namespace ticker::candidates {
namespace {

struct Renaming {
    std::string_view from;
    std::string_view to;
};

constexpr std::array kFunctions{Renaming{"sin", "cos"},     Renaming{"cos", "sin"},
                                Renaming{"asin", "acos"},   Renaming{"acos", "asin"},
                                Renaming{"min", "max"},     Renaming{"max", "min"},
                                Renaming{"floor", "ceil"},  Renaming{"ceil", "floor"},
                                Renaming{"round", "floor"}, Renaming{"lround", "floor"}};

/// Where the name of the called function stands: the last word of the callee.
std::optional<Range> nameOf(const Edits& edits, const Node& call) {
    const auto tokens = edits.source().tokensIn(edits.tree().at(call.children.front()).range);
    for (auto token = tokens.rbegin(); token != tokens.rend(); ++token)
        if (edits.source().in(*token) == call.name) return *token;
    return std::nullopt;
}

void exchangeArguments(Edits& edits, int index, const std::vector<int>& arguments) {
    const Tree& tree = edits.tree();
    for (std::size_t a = 0; a < arguments.size(); ++a)
        for (std::size_t b = a + 1; b < arguments.size(); ++b) {
            const Node& one = tree.at(arguments[a]);
            const Node& two = tree.at(arguments[b]);
            if (one.type == two.type && one.isExpression)
                edits.add(
                    "exchange", index,
                    {{one.range, edits.text(arguments[b])}, {two.range, edits.text(arguments[a])}});
        }
}

/// Replaces an argument by the negative of another one, as in a range around 0.
void negateNeighbour(Edits& edits, const std::vector<int>& arguments) {
    for (const int one : arguments)
        for (const int other : arguments)
            if (one != other && edits.isType(one, "double") && edits.isType(other, "double"))
                edits.replace("bound", one, "-" + edits.operand(other), false);
}

/// Replaces a number by what another call of the same function is given in its place.
void giveAsInOtherCall(Edits& edits, int index, const Node& call) {
    const Tree& tree = edits.tree();
    const int function = outermostFunction(tree, index);
    for (int other = 0; other < static_cast<int>(tree.nodes.size()); ++other) {
        const Node& twin = tree.at(other);
        if (other == index || twin.kind != NodeKind::call || twin.name != call.name ||
            twin.children.size() != call.children.size() ||
            outermostFunction(tree, other) != function)
            continue;
        for (std::size_t i = 1; i < call.children.size(); ++i) {
            const int given = twin.children[i];
            if (tree.at(call.children[i]).kind == NodeKind::number &&
                tree.at(given).type == tree.at(call.children[i]).type &&
                isUsableAt(tree, given, index))
                edits.replace("argument", call.children[i], edits.text(given), true);
        }
    }
}

/// Replaces atan(a / b), which cannot tell the quadrant, by atan2(a, b).
void nameQuadrant(Edits& edits, int index, const Node& call) {
    if (call.name != "atan" || call.children.size() != 2) return;
    const Tree& tree = edits.tree();
    const Node& quotient = tree.at(call.children[1]);
    if (quotient.kind != NodeKind::binary || quotient.name != "/") return;
    edits.replace("function", index,
                  "std::atan2(" + edits.bareText(quotient.children[0]) + ", " +
                      edits.bareText(quotient.children[1]) + ")",
                  true);
}

void editMethod(Edits& edits, int index, const Node& call, const Node& callee) {
    if (callee.children.empty()) return;
    const int object = callee.children.front();
    const Tree& tree = edits.tree();
    if (tree.at(object).type == call.type) edits.replaceBy("unwrap", index, object);
    if (call.children.size() == 2) {
        const int argument = call.children[1];
        if (tree.at(argument).type == tree.at(object).type)
            edits.add("exchange", index,
                      {{tree.at(object).range, edits.operand(argument)},
                       {tree.at(argument).range, edits.bareText(object)}});
    }
}

}  // namespace

void addCallEdits(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (node.kind == NodeKind::list) {
        exchangeArguments(edits, index, node.children);
        return;
    }
    if (node.kind == NodeKind::cast && !node.children.empty() && node.isExpression &&
        tree.at(node.children.back()).isExpression &&
        tree.at(node.children.back()).kind != NodeKind::list)
        edits.replaceBy("cast", index, node.children.back());
    const bool isConstructor = !node.isExpression;
    if (node.kind != NodeKind::call || node.children.empty() || isConstructor) return;
    const Node& callee = tree.at(node.children.front());
    if (node.name == "dot" && edits.isType(index, "double"))
        edits.replace("clamp", index, "std::max(0.0, " + edits.text(index) + ")", true);
    std::vector<int> arguments{node.children.begin() + 1, node.children.end()};
    exchangeArguments(edits, index, arguments);
    negateNeighbour(edits, arguments);
    nameQuadrant(edits, index, node);
    giveAsInOtherCall(edits, index, node);
    for (const int argument : arguments)
        if (tree.at(argument).type == node.type) edits.replaceBy("unwrap", index, argument);
    if (callee.kind == NodeKind::member) editMethod(edits, index, node, callee);
    if (const std::optional<Range> name = nameOf(edits, node))
        for (const Renaming& renaming : kFunctions)
            if (node.name == renaming.from)
                edits.add("function", index, {{*name, std::string{renaming.to}}});
}

void addWrapEdits(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (!node.isExpression || node.kind == NodeKind::number || node.parent < 0) return;
    const Node& around = tree.at(node.parent);
    const bool isArgument = (around.kind == NodeKind::call || around.kind == NodeKind::list) &&
                            (!around.isExpression || around.children.front() != index);
    const bool isWhole = !around.isExpression || isArgument ||
                         around.kind == NodeKind::parentheses || around.kind == NodeKind::cast;
    if (!isWhole || node.kind == NodeKind::parentheses || node.kind == NodeKind::function) return;
    const std::string text = edits.text(index);
    const std::string operand = edits.operand(index);
    if (edits.isNumber(index) || edits.isVector(index))
        if (node.kind != NodeKind::unary) edits.replace("sign", index, "-" + operand, false);
    if (edits.isVector(index) && node.type == "raytracer::Vector3" && node.name != "normalised")
        edits.replace("normalise", index, operand + ".normalised()", true);
    if (edits.isType(index, "double")) {
        edits.replace("factor", index, "2.0 * " + operand, false);
        edits.replace("factor", index, "0.5 * " + operand, false);
        if (!isArgument) {
            edits.replace("term", index, text + " + 0.5", false);
            edits.replace("term", index, "1.0 - " + operand, false);
        }
        if (isArgument && (around.name == "acos" || around.name == "asin") && node.name != "clamp")
            edits.replace("clamp", index, "std::clamp(" + text + ", -1.0, 1.0)", true);
    }
    if (edits.isInteger(index)) {
        edits.replace("term", index, text + " + 1", false);
        edits.replace("term", index, text + " - 1", false);
    }
}

}  // namespace ticker::candidates
