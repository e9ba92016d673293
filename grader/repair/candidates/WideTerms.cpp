#include <grader/repair/candidates/WideTerms.h>

#include <grader/repair/candidates/Scope.h>

#include <algorithm>
#include <iterator>

namespace ticker::candidates {
namespace {

constexpr std::size_t kFewTokens = 14;

/// Sums of numbers: with another variable, or with what the function does not use yet.
void addNumberTerms(Edits& edits, int index, const Vocabulary& words) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    const Node& around = tree.at(node.parent);
    const bool isDivided = around.kind == NodeKind::binary && around.name == "/" &&
                           around.children.front() == index && node.kind == NodeKind::unary;
    if (node.kind == NodeKind::number || (!isDivided && !standsAlone(tree, index))) return;
    if (edits.source().tokensIn(node.range).size() > kFewTokens) return;
    std::vector<std::string> others;
    if (isDivided) others = words.variables("double");
    for (const std::string& quantity : words.unused("double")) {
        others.push_back(quantity);
        others.push_back(quantity + " * " + quantity);
    }
    for (const std::string& other : others)
        for (const char* sign : {" - ", " + "})
            edits.replace("term", index, edits.text(index) + sign + other, false);
}

/// The same component of another point is taken away: `P.x - C.x`.
void addComponentTerms(Edits& edits, int index, const Vocabulary& words) {
    const Node& node = edits.tree().at(index);
    if (node.kind != NodeKind::member || node.children.size() != 1) return;
    const int object = node.children.front();
    if (!edits.isType(object, "raytracer::Vector3")) return;
    for (const std::string& place : words.places())
        if (place != edits.text(object))
            edits.replace("term", index, edits.text(index) + " - " + place + "." + node.name,
                          false);
}

/// Another direction, of unit length or turned round.
void addDirections(Edits& edits, int index, const Vocabulary& words) {
    const Node& node = edits.tree().at(index);
    constexpr std::size_t kMostTokens = 6;
    const Node& around = edits.tree().at(node.parent);
    const bool isAsked = around.kind == NodeKind::member;
    if (node.kind == NodeKind::number || (!isAsked && !standsAlone(edits.tree(), index))) return;
    if (edits.source().tokensIn(node.range).size() > kMostTokens) return;
    for (const std::string& word : words.variables("raytracer::Vector3")) {
        if (word == edits.text(index)) continue;
        edits.replace("word", index, word + ".normalised()", true);
        edits.replace("word", index, "-" + word, false);
    }
}

/// Adds the rest of another colour to a share of this one: b * (1 - s) + a * s.
void addBlends(Edits& edits, int index, const Vocabulary& words) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (node.kind != NodeKind::binary || node.name != "*" || !standsAlone(tree, index)) return;
    if (!edits.isType(node.children[1], "double")) return;
    for (const std::string& colour : words.variables("raytracer::ColourRGB"))
        edits.replace(
            "blend", index,
            colour + " * (1.0 - " + edits.text(node.children[1]) + ") + " + edits.text(index),
            false);
}

/// The number that a product ends with; -1: none.
int numberOf(const Tree& tree, int index) {
    const Node& node = tree.at(index);
    if (node.kind != NodeKind::binary || node.name != "*") return -1;
    return tree.at(node.children[1]).kind == NodeKind::number ? node.children[1] : -1;
}

/// Replaces two shares that are written as numbers, `a * 0.7 + b * 0.3`, by a quantity and 1 minus
/// it.
void addShares(Edits& edits, int index, const Vocabulary& words) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (node.kind != NodeKind::binary || node.name != "+") return;
    const int one = numberOf(tree, node.children[0]);
    const int other = numberOf(tree, node.children[1]);
    if (one < 0 || other < 0) return;
    std::vector<std::string> shares = words.variables("double");
    std::ranges::copy(words.numbers(), std::back_inserter(shares));
    for (const std::string& share : shares) {
        const std::string rest = "(1.0 - " + share + ")";
        edits.add("blend", index, {{tree.at(one).range, rest}, {tree.at(other).range, share}});
        edits.add("blend", index, {{tree.at(one).range, share}, {tree.at(other).range, rest}});
    }
}

/// Counts a hit only if it is nearer than the one that is kept.
void addNearest(Edits& edits, int index, const Node& hit, const Node& kept) {
    for (const Quantity& part : kept.parts)
        if (part.type == "double" && part.argument.empty())
            edits.add("limit", index,
                      {{edits.tree().at(index).range, "(" + hit.name + " && (!" + kept.name +
                                                          " || " + hit.name + part.text + " < " +
                                                          kept.name + part.text + "))"}});
}

/// Adds a comparison to a test that asks only whether there is a hit, such as of its distance with
/// a limit.
void addLimits(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    const bool isNegated = node.kind == NodeKind::unary && node.name == "!";
    int at = index;
    if (isNegated && !node.children.empty()) at = node.children.front();
    // hit.has_value()
    while ((tree.at(at).kind == NodeKind::call || tree.at(at).kind == NodeKind::member) &&
           tree.at(at).name == "has_value" && !tree.at(at).children.empty())
        at = tree.at(at).children.front();
    const Node& asked = tree.at(at);
    if (asked.kind != NodeKind::name || edits.text(index).ends_with("->")) return;
    if (!asked.type.starts_with("std::optional<")) return;
    const std::vector<int> variables = visibleVariables(tree, index);
    std::vector<std::string> limits;
    for (const int variable : variables) {
        const Node& one = tree.at(variable);
        if (one.type == "double") limits.push_back(one.name);
        if (one.type == "raytracer::Vector3") limits.push_back(one.name + ".magnitude()");
    }
    for (const int variable : variables) {
        const Node& other = tree.at(variable);
        if (other.isOptional && other.name != asked.name && !isNegated)
            addNearest(edits, index, asked, other);
    }
    for (const int variable : variables) {
        const Node& hit = tree.at(variable);
        if (hit.name != asked.name || !hit.isOptional) continue;
        for (const Quantity& part : hit.parts)
            for (const std::string& limit : limits) {
                if (part.type != "double" || !part.argument.empty()) continue;
                const std::string number = hit.name + part.text;
                edits.add("limit", index,
                          {{node.range,
                            isNegated ? "(!" + hit.name + " || " + number + " > " + limit + ")"
                                      : "(" + hit.name + " && " + number + " < " + limit + ")"}});
            }
    }
}

/// Hands the ray to another function that returns a hit.
void addFinders(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    if (node.kind != NodeKind::call || node.children.size() != 2 || !node.isExpression) return;
    if (!node.type.starts_with("std::optional<")) return;
    const Vocabulary words{edits, index};
    for (const std::string& function : words.functions(node.type))
        edits.replace("word", index, function + "(" + edits.text(node.children[1]) + ")", true);
}

}  // namespace

bool standsAlone(const Tree& tree, int index) {
    const Node& around = tree.at(tree.at(index).parent);
    return !around.isExpression || around.kind == NodeKind::list ||
           around.kind == NodeKind::parentheses ||
           (around.kind == NodeKind::call && around.children.front() != index);
}

void addWideTerms(Edits& edits, int index, const Vocabulary& words) {
    const Node& node = edits.tree().at(index);
    if (node.parent < 0) return;
    // Replaces a literal integer argument by a quantity.
    if (edits.isInteger(index) && node.kind == NodeKind::number &&
        edits.tree().at(node.parent).kind == NodeKind::call)
        for (const std::string& word : words.unused("double"))
            edits.replace("word", index, word, true);
    if (edits.isType(index, "double")) {
        addNumberTerms(edits, index, words);
        addComponentTerms(edits, index, words);
    }
    if (edits.isType(index, "raytracer::Vector3")) addDirections(edits, index, words);
    if (edits.isType(index, "raytracer::ColourRGB")) {
        addBlends(edits, index, words);
        addShares(edits, index, words);
    }
}

void addHitEdits(Edits& edits, int index) {
    addLimits(edits, index);
    addFinders(edits, index);
}

}  // namespace ticker::candidates
