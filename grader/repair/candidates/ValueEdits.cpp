#include <grader/repair/candidates/Atom.h>
#include <grader/repair/candidates/Scope.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace ticker::candidates {
namespace {

void exchangeNames(Edits& edits, int index, const Node& node) {
    // All uses of two variables of one type, throughout a statement's expression.
    const Tree& tree = edits.tree();
    const int top = tree.topOf(index);
    std::vector<int> uses;
    for (int i = top; i < static_cast<int>(tree.nodes.size()); ++i) {
        if (!tree.at(top).range.holds(tree.at(i).range)) break;
        if (tree.at(i).kind == NodeKind::name && tree.at(i).type == node.type) uses.push_back(i);
    }
    for (const int other : uses) {
        if (other <= index || tree.at(other).name == node.name) continue;
        std::vector<Replacement> all;
        for (const int use : uses) {
            if (tree.at(use).name == node.name)
                all.push_back({tree.at(use).range, edits.text(other)});
            if (tree.at(use).name == tree.at(other).name)
                all.push_back({tree.at(use).range, edits.text(index)});
        }
        if (all.size() > 2) edits.add("exchange", top, all);
        edits.add("exchange", top,
                  {{node.range, edits.text(other)}, {tree.at(other).range, edits.text(index)}});
    }
}

/// Whether a declaration is of a constant, or gives a variable a number.
bool isOfConstant(const Tree& tree, const Node& declaration) {
    return declaration.kind == NodeKind::declaration &&
           (declaration.isConstant ||
            (!declaration.children.empty() &&
             tree.at(declaration.children.back()).kind == NodeKind::number));
}

bool isConstant(const Tree& tree, int index) {
    const Node& node = tree.at(index);
    if (node.kind == NodeKind::number) return true;
    return node.kind == NodeKind::name && std::ranges::any_of(tree.nodes, [&](const Node& one) {
               return one.declared == node.declared && isOfConstant(tree, one);
           });
}

/// Whether a node is compared with a constant: another constant in its place decides nothing.
bool isComparedWithConstant(const Tree& tree, int index) {
    const Node& around = tree.at(std::max(0, tree.at(index).parent));
    if (!isComparison(around)) return false;
    const bool isLeft = around.children.front() == index;
    return isConstant(tree, isLeft ? around.children.back() : around.children.front());
}

/// For the left operand of `x * x`: index of the right operand; -1 for any other node.
int twinInSquare(const Edits& edits, int index) {
    const Node& around = edits.tree().at(std::max(0, edits.tree().at(index).parent));
    if (around.kind != NodeKind::binary || around.name != "*") return -1;
    const int twin = around.children.back();
    return around.children.front() == index && edits.text(twin) == edits.text(index) ? twin : -1;
}

std::string negated(const std::string& text) {
    return text.starts_with('-') ? text.substr(1) : "-" + text;
}

}  // namespace

void addNumberEdits(Edits& edits, int index) {
    const Node& node = edits.tree().at(index);
    if (node.kind != NodeKind::number || !edits.isNumber(index)) return;
    const std::string text = edits.text(index);
    const Node& around = edits.tree().at(std::max(0, node.parent));
    const bool isTerm =
        around.kind == NodeKind::binary && (around.name == "+" || around.name == "-");
    const bool isFactor =
        around.kind == NodeKind::binary && (around.name == "*" || around.name == "/");
    // A term 0 or a factor 1 amounts to dropping it, which is an edit of its own.
    const auto isIdle = [&](std::string_view other) {
        return (isTerm && (other == "0" || other == "0.0")) ||
               (isFactor && (other == "1" || other == "1.0"));
    };
    // "0" instead of "-0".
    const bool isNegative = around.kind == NodeKind::unary && around.name == "-";
    static constexpr std::array kReals{"0.0", "0.5", "1.0", "2.0"};
    static constexpr std::array kWhole{"0", "1", "2"};
    if (edits.isInteger(index)) {
        for (const std::string_view other : kWhole)
            if (!isIdle(other))
                edits.replace("number", isNegative && other == "0" ? node.parent : index,
                              std::string{other}, true);
        int value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc{} && end == text.data() + text.size() && value < 100'000) {
            edits.replace("number", index, std::to_string(value + 1), true);
            if (value > (isNegative ? 1 : 0) && !isIdle(std::to_string(value - 1)))
                edits.replace("number", index, std::to_string(value - 1), true);
        }
    } else {
        for (const std::string_view other : kReals)
            if (!isIdle(other))
                edits.replace("number", isNegative && other == "0.0" ? node.parent : index,
                              std::string{other}, true);
        edits.replace("number", index, "std::numbers::pi", true);
    }
    edits.replace("sign", index, negated(text), false);
}

void addNameEdits(Edits& edits, int index) {
    const Node& node = edits.tree().at(index);
    const bool isCounted = node.parent >= 0 && isCounting(edits.tree().at(node.parent));
    if (node.kind != NodeKind::name || isCounted) return;
    // Points, colours, and whatever else the kit has: a ray for another ray, a picture for another.
    if (!edits.isNumber(index) && !node.type.starts_with("raytracer::")) return;
    constexpr std::size_t kMost = 6;
    std::vector<int> others = visibleVariables(edits.tree(), index);
    const bool needsVariable = isComparedWithConstant(edits.tree(), index);
    std::erase_if(others, [&](int other) {
        const Node& one = edits.tree().at(other);
        return one.type != node.type || (needsVariable && isOfConstant(edits.tree(), one));
    });
    const std::size_t skipped = others.size() > kMost ? others.size() - kMost : 0;
    const int twin = twinInSquare(edits, index);
    for (std::size_t i = skipped; i < others.size(); ++i) {
        const std::string& name = edits.tree().at(others[i]).name;
        edits.replace("name", index, name, true);
        if (twin >= 0)
            edits.add("name", node.parent,
                      {{node.range, name}, {edits.tree().at(twin).range, name}});
    }
    exchangeNames(edits, index, node);
}

void addMemberEdits(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (node.kind != NodeKind::member || node.children.empty()) return;
    constexpr std::size_t kMost = 8;
    const Range name{node.range.end - node.name.size(), node.range.end};
    if (edits.source().in(name) != node.name) return;
    const bool isCalled = node.parent >= 0 && tree.at(node.parent).kind == NodeKind::call &&
                          tree.at(node.parent).children.front() == index;
    const int site = isCalled ? node.parent : index;
    for (std::size_t i = 0; i < std::min(kMost, node.siblings.size()); ++i)
        edits.add("member", site, {{name, node.siblings[i]}});
}

}  // namespace ticker::candidates
