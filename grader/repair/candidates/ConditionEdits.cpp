#include <grader/repair/candidates/Atom.h>
#include <grader/repair/candidates/Scope.h>

#include <charconv>
#include <set>

namespace ticker::candidates {
namespace {

/// Replaces an if by each of its branches, as if its condition were constant.
void decideBranch(Edits& edits, int index) {
    const Node& node = edits.tree().at(index);
    if (node.children.size() < 2 || !edits.tree().at(node.children.front()).isExpression) return;
    for (std::size_t i = 1; i < node.children.size(); ++i) {
        const Range guarded = wholeOf(edits, node.children[i]);
        edits.addInstead("always", index, wholeOf(edits, index),
                         std::string{edits.source().in(guarded)});
    }
}

/// Makes a return within a loop conditional. A loop that returns in its first round often knows
/// only one of the two answers for certain by then.
void returnWhenCertain(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (loopAround(tree, index) < 0 || node.children.size() != 1) return;
    const int value = node.children.front();
    const std::string text = edits.text(value);
    const Range whole = wholeOf(edits, index);
    if (edits.isType(value, "bool")) {
        edits.addInstead("jump", index, whole, "if (" + text + ") return true;");
        edits.addInstead("jump", index, whole, "if (!(" + text + ")) return false;");
    }
    if (tree.at(value).type.starts_with("std::optional<") && tree.at(value).kind == NodeKind::name)
        edits.addInstead("jump", index, whole, "if (" + text + ") return " + text + ";");
}

/// Adds a break after a guarded statement in a loop, as where each ray must count only once.
void leaveLoop(Edits& edits, int index) {
    static const std::set<std::string> kChanging{"=", "+=", "-="};
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (node.parent < 0 || loopAround(tree, index) < 0) return;
    const bool isBraced = tree.at(node.parent).kind == NodeKind::block;
    const int branch = isBraced ? tree.at(node.parent).parent : node.parent;
    const bool isGuarded = branch >= 0 && tree.at(branch).kind == NodeKind::branch &&
                           tree.at(branch).children.front() != index;
    const bool changes =
        isCounting(node) || (node.kind == NodeKind::binary && kChanging.contains(node.name));
    if (!isGuarded || !changes) return;
    const std::string both = edits.text(index) + "; break;";
    edits.addInstead("jump", index, wholeOf(edits, index), isBraced ? both : "{ " + both + " }");
}

/// Replaces `return {f(c.r), f(c.g), f(c.b)};` by `return c;`.
void returnWhole(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (node.children.size() != 1 || !edits.text(node.children.front()).starts_with('{')) return;
    const Node& list = tree.at(node.children.front());
    std::set<std::string> objects;
    std::size_t members = 0;
    for (int i = node.children.front(); i < static_cast<int>(tree.nodes.size()); ++i) {
        const Node& one = tree.at(i);
        if (!list.range.holds(one.range)) break;
        if (one.kind != NodeKind::member || one.children.size() != 1) continue;
        if (!edits.isVector(one.children.front())) continue;
        objects.insert(edits.text(one.children.front()));
        ++members;
    }
    if (objects.size() == 1 && members == list.children.size())
        edits.addInstead("unwrap", index, wholeOf(edits, index),
                         "return " + *objects.begin() + ";");
}

/// Negates a condition that has several parts or is a call. A single comparison is not negated
/// here, since its operator is exchanged elsewhere.
void negate(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (!edits.isType(index, "bool") || node.parent < 0) return;
    // A condition that already holds `!` is not negated: students do not make that mistake.
    if (edits.text(index).find('!') != std::string::npos) return;
    const Node& around = tree.at(node.parent);
    const bool decides = around.kind == NodeKind::branch && around.children.front() == index;
    const bool isValue = around.kind == NodeKind::declaration || around.kind == NodeKind::jump;
    const bool isCompound =
        node.kind == NodeKind::binary && (node.name == "&&" || node.name == "||");
    if ((decides || isValue) && (isCompound || node.kind == NodeKind::call))
        edits.replace("sign", index, "!" + edits.operand(index), false);
}

/// The number that a node is, or that a variable was declared with; 0 for any other node.
double numberOf(const Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const int number =
        tree.at(index).kind == NodeKind::name ? initialiserOf(tree, tree.at(index)) : index;
    if (number < 0 || tree.at(number).kind != NodeKind::number) return 0.0;
    const std::string text = edits.text(number);
    double value = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

/// Brings a threshold near to 0 or 1 much nearer: what guards against a division by zero should
/// leave nothing else out.
void tightenThreshold(Edits& edits, const Node& comparison) {
    constexpr double kNear = 0.2;
    for (const int side : comparison.children) {
        if (!edits.isType(side, "double")) continue;
        const double value = numberOf(edits, side);
        if (value > 0.0 && value <= kNear) edits.replace("threshold", side, "1e-9", true);
        if (value >= 1.0 - kNear && value < 1.0)
            edits.replace("threshold", side, "0.9999999", true);
    }
}

}  // namespace

void addConditionEdits(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (node.kind == NodeKind::branch) decideBranch(edits, index);
    if (node.kind == NodeKind::jump) {
        returnWhenCertain(edits, index);
        returnWhole(edits, index);
    }
    if (!node.isExpression) return;
    if (isComparison(node)) tightenThreshold(edits, node);
    leaveLoop(edits, index);
    negate(edits, index);
    const bool isFlag = edits.isType(index, "bool") && node.parent >= 0 &&
                        tree.at(node.parent).kind == NodeKind::declaration;
    if (!isFlag) return;
    edits.replace("always", index, "true", true);
    edits.replace("always", index, "false", true);
}

}  // namespace ticker::candidates
