#include <grader/repair/candidates/Atom.h>

#include <algorithm>
#include <optional>

namespace ticker::candidates {
namespace {

const std::set<std::string> kAssigning{"=", "+=", "-=", "*=", "/=", "%="};

bool holdsTogether(const Node& node) {
    switch (node.kind) {
        case NodeKind::name:
        case NodeKind::number:
        case NodeKind::member:
        case NodeKind::call:
        case NodeKind::parentheses:
        case NodeKind::cast:
        case NodeKind::list:
            return true;
        default:
            return false;
    }
}

/// Whether a text in place of a node needs no parentheses, because of what stands around it.
bool isEnclosed(const Tree& tree, int node) {
    const int parent = tree.at(node).parent;
    if (parent < 0 || !tree.at(parent).isExpression) return true;
    const Node& around = tree.at(parent);
    const bool isArgument = around.kind == NodeKind::call && around.children.front() != node;
    const bool isAssigned = around.kind == NodeKind::binary && around.children.back() == node &&
                            kAssigning.contains(around.name);
    return isArgument || isAssigned || around.kind == NodeKind::parentheses ||
           around.kind == NodeKind::list || around.kind == NodeKind::cast;
}

/// The expression that changes what a node stands for, such as `a = b` for its a: a switch cannot
/// stand at a itself. A node that is only read stands for itself.
int assignedAt(const Tree& tree, int node) {
    int site = node;
    for (int at = node; tree.at(at).parent >= 0 && tree.at(tree.at(at).parent).isExpression;
         at = tree.at(at).parent) {
        const Node& around = tree.at(tree.at(at).parent);
        const bool isLeft = around.kind == NodeKind::binary && kAssigning.contains(around.name) &&
                            around.children.front() == at;
        const bool isCounted = around.kind == NodeKind::unary && around.name != "-" &&
                               around.name != "!" && around.name != "*";
        if (isLeft || isCounted) site = tree.at(at).parent;
        if (around.kind != NodeKind::member && around.kind != NodeKind::parentheses && !isLeft &&
            !isCounted)
            break;
    }
    return site;
}

/// A part's text after edits within it.
std::string editedText(const Edits& edits, int part, const Atom& atom) {
    const Range& range = edits.tree().at(part).range;
    std::vector<Replacement> within;
    for (const Replacement& edit : atom.edits)
        if (range.holds(edit.range)) within.push_back(edit);
    return applied(edits.text(part), range.begin, std::move(within));
}

/// Whether an edit makes `x = x` or `x < x`, which is never a repair.
bool saysNothing(const Edits& edits, const Atom& atom) {
    const Tree& tree = edits.tree();
    for (int at = atom.site; at >= 0 && tree.at(at).isExpression; at = tree.at(at).parent) {
        const Node& node = tree.at(at);
        const bool isAssignment = node.kind == NodeKind::binary && node.name == "=";
        if ((isAssignment || isComparison(node)) &&
            editedText(edits, node.children.front(), atom) ==
                editedText(edits, node.children.back(), atom))
            return true;
    }
    return false;
}

/// The expression or statement that can hold the switch of an edit, which is made in its text or
/// before it; empty: none can.
std::optional<int> switchSite(const Edits& edits, const Atom& atom) {
    const Tree& tree = edits.tree();
    int site = tree.at(atom.site).isExpression ? assignedAt(tree, atom.site) : atom.site;
    // A list in braces has no type of its own, so the switch moves to the expression around it.
    while (tree.at(site).isExpression && edits.text(site).starts_with('{')) {
        site = tree.at(site).parent;
        if (site < 0 || !tree.at(site).isExpression) return std::nullopt;
    }
    const bool holdsAll = std::ranges::all_of(
        atom.edits, [&](const Replacement& edit) { return tree.at(site).range.holds(edit.range); });
    return holdsAll ? std::optional{site} : std::nullopt;
}

}  // namespace

std::string Edits::bareText(int node) const {
    while (tree_.at(node).kind == NodeKind::parentheses && tree_.at(node).children.size() == 1)
        node = tree_.at(node).children.front();
    return text(node);
}

std::string Edits::operand(int node) const {
    return holdsTogether(tree_.at(node)) ? text(node) : "(" + text(node) + ")";
}

bool Edits::isVector(int node) const {
    return isType(node, "raytracer::Vector3") || isType(node, "raytracer::ColourRGB");
}

void Edits::insert(Atom atom) {
    if (!atom.isInstead) {
        const std::optional<int> site = switchSite(*this, atom);
        if (!site) return;
        atom.site = *site;
        if (!atom.isBefore && saysNothing(*this, atom)) return;
    }
    const bool changesNothing = std::ranges::any_of(atom.edits, [this](const Replacement& edit) {
        return source_.in(edit.range) == edit.text;
    });
    // Two edits that make the same text are one.
    if (!changesNothing && known_.insert(atom.edits).second) atoms_.push_back(std::move(atom));
}

void Edits::add(std::string kind, int site, std::vector<Replacement> edits) {
    insert({std::move(kind), std::move(edits), site, false, false, false});
}

void Edits::addApart(std::string kind, int site, std::vector<Replacement> edits) {
    insert({std::move(kind), std::move(edits), site, true, false, false});
}

void Edits::addBefore(std::string kind, int statement, const Range& place,
                      const std::string& text) {
    insert({std::move(kind), {{place, text}}, statement, false, true, false});
}

void Edits::addInstead(std::string kind, int statement, const Range& whole,
                       const std::string& text) {
    insert({std::move(kind), {{whole, text}}, statement, false, false, true});
}

void Edits::replace(const std::string& kind, int node, const std::string& text, bool isPrimary) {
    const bool isSafe = isPrimary || isEnclosed(tree_, node);
    add(kind, node, {{tree_.at(node).range, isSafe ? text : "(" + text + ")"}});
}

void Edits::replaceBy(const std::string& kind, int node, int other) {
    if (isEnclosed(tree_, node))
        replace(kind, node, bareText(other), true);
    else
        replace(kind, node, operand(other), true);
}

std::string applied(std::string text, std::size_t begin, std::vector<Replacement> edits) {
    std::ranges::sort(edits, {}, &Replacement::key);
    for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit)
        text.replace(edit->range.begin - begin, edit->range.size(), edit->text);
    return text;
}

}  // namespace ticker::candidates
