#include <grader/repair/candidates/Atom.h>
#include <grader/repair/candidates/Scope.h>

#include <algorithm>
#include <iterator>

namespace ticker::candidates {
namespace {

constexpr std::size_t kMostVariables = 5;

/// What a node's function could name.
class Vocabulary {
public:
    Vocabulary(const Edits& edits, int index) : edits_(edits) {
        const Tree& tree = edits.tree();
        const int function = outermostFunction(tree, index);
        if (function < 0) return;
        const std::string_view used = edits.source().in(tree.at(function).range);
        for (const Quantity& own : tree.at(function).parts)
            addUnused(own, used);
        for (const Quantity& constant : tree.constants)
            addUnused(constant, used);
        for (const int variable : visibleVariables(tree, index)) {
            const Node& node = tree.at(variable);
            for (const Quantity& part : node.parts)
                if (!edits.isVector(variable)) addUnused({node.name + part.text, part.type}, used);
            variables_.push_back({node.name, node.type});
        }
    }

    /// Variables of a type, the nearest first.
    [[nodiscard]] std::vector<std::string> variables(std::string_view type) const {
        std::vector<std::string> texts;
        for (auto variable = variables_.rbegin();
             variable != variables_.rend() && texts.size() < kMostVariables; ++variable)
            if (variable->type == type) texts.push_back(variable->text);
        return texts;
    }
    /// Quantities of a type that the function does not use yet.
    [[nodiscard]] std::vector<std::string> unused(std::string_view type) const {
        std::vector<std::string> texts;
        for (const Quantity& quantity : unused_)
            if (quantity.type == type) texts.push_back(quantity.text);
        return texts;
    }
    /// Points and directions, used or not.
    [[nodiscard]] std::vector<std::string> points() const {
        std::vector<std::string> texts = variables("raytracer::Vector3");
        texts.insert(texts.end(), points_.begin(), points_.end());
        return texts;
    }
    [[nodiscard]] std::vector<std::string> colours() const {
        std::vector<std::string> texts = variables("raytracer::ColourRGB");
        texts.insert(texts.end(), colours_.begin(), colours_.end());
        return texts;
    }
    [[nodiscard]] std::vector<std::string> all(std::string_view type) const {
        std::vector<std::string> texts = variables(type);
        std::ranges::move(unused(type), std::back_inserter(texts));
        return texts;
    }

private:
    void addUnused(const Quantity& quantity, std::string_view used) {
        if (quantity.type == "raytracer::Vector3") points_.push_back(quantity.text);
        if (quantity.type == "raytracer::ColourRGB") colours_.push_back(quantity.text);
        if (used.find(quantity.text) == std::string_view::npos) unused_.push_back(quantity);
    }

    const Edits& edits_;
    std::vector<Quantity> variables_;
    std::vector<Quantity> unused_;
    std::vector<std::string> points_;
    std::vector<std::string> colours_;
};

/// Whether a node is a whole initialiser, value or argument.
bool standsAlone(const Tree& tree, int index) {
    const Node& around = tree.at(tree.at(index).parent);
    return !around.isExpression || around.kind == NodeKind::list ||
           around.kind == NodeKind::parentheses ||
           (around.kind == NodeKind::call && around.children.front() != index);
}

/// Whether a line ends between two places.
bool goesOn(const Edits& edits, std::size_t begin, std::size_t end) {
    return edits.source().in({begin, end}).find('\n') != std::string_view::npos;
}

/// Whether a node is whole, a term of a sum, what a method is called for, or the first line of a
/// product.
bool isTerm(const Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    const Node& around = tree.at(node.parent);
    if (around.kind == NodeKind::binary && (around.name == "*" || around.name == "/"))
        return around.children.front() == index && goesOn(edits, node.range.end, around.range.end);
    if (around.kind == NodeKind::binary) return around.name != "=";
    return around.kind == NodeKind::member || standsAlone(tree, index);
}

void addReplacements(Edits& edits, int index, const Vocabulary& words) {
    const Node& node = edits.tree().at(index);
    constexpr std::size_t kMostTokens = 6;
    const bool isSmall = node.kind == NodeKind::number || node.kind == NodeKind::name ||
                         node.kind == NodeKind::member || node.kind == NodeKind::call ||
                         node.kind == NodeKind::unary;
    if (!isSmall || edits.source().tokensIn(node.range).size() > kMostTokens) return;
    const bool isPoint = edits.isType(index, "raytracer::Vector3");
    for (const std::string& word : isPoint ? words.points() : words.all(node.type))
        edits.replace("word", index, word, true);
    if (edits.isType(index, "double") && node.kind == NodeKind::number)
        for (const std::string& word : words.unused("int"))
            edits.replace("word", index, word, true);
}

void addFactors(Edits& edits, int index, const Vocabulary& words) {
    const Node& node = edits.tree().at(index);
    const bool isProduct = node.kind == NodeKind::binary && (node.name == "*" || node.name == "/");
    const std::string operand = isProduct ? edits.text(index) : edits.operand(index);
    const Node& around = edits.tree().at(node.parent);
    const bool holds = around.kind == NodeKind::binary && around.name != "*" && around.name != "/";
    const bool isPoint = edits.isType(index, "raytracer::Vector3");
    std::vector<std::string> factors = isPoint ? words.unused("double") : words.all("double");
    if (edits.isType(index, "raytracer::ColourRGB"))
        std::ranges::move(words.colours(), std::back_inserter(factors));
    if (edits.isType(index, "double")) factors.emplace_back("4.0");
    for (const std::string& factor : factors)
        if (factor != edits.text(index))
            edits.replace("factor", index, operand + " * " + factor, holds);
    if (isPoint || !standsAlone(edits.tree(), index)) return;
    if (edits.isType(index, "double"))
        for (const std::string& point : words.points())
            for (const char* axis : {".x", ".y", ".z"})
                edits.replace("factor", index, operand + " / " + point + axis, false);
    for (const char* type : {"double", "int"})
        for (const std::string& factor : words.all(type))
            if (factor != edits.text(index))
                edits.replace("factor", index, operand + " / " + factor, holds);
}

/// A point that is moved a little along a direction.
void addSteps(Edits& edits, int index, const Vocabulary& words) {
    if (edits.tree().at(index).kind != NodeKind::name || !standsAlone(edits.tree(), index)) return;
    for (const std::string& along : words.variables("raytracer::Vector3"))
        for (const std::string& length : words.unused("double"))
            if (along != edits.text(index))
                edits.replace("step", index, edits.text(index) + " + " + along + " * " + length,
                              false);
}

void addTerms(Edits& edits, int index, const Vocabulary& words) {
    const Node& node = edits.tree().at(index);
    constexpr std::size_t kMostTokens = 6;
    if (edits.source().tokensIn(node.range).size() > kMostTokens) return;
    for (const std::string& word : words.points()) {
        if (word == edits.text(index)) continue;
        if (node.kind == NodeKind::unary && node.name == "-") {
            edits.replace("term", index, word + " " + edits.text(index), false);
            continue;
        }
        edits.replace("term", index, edits.text(index) + " - " + word, false);
        edits.replace("term", index, edits.text(index) + " + " + word, false);
        edits.replace("term", index, word + " - " + edits.operand(index), false);
    }
}

/// An optional hit that is asked for alone: whether it counts may depend on its numbers.
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
    if (asked.kind != NodeKind::name) return;
    if (!asked.type.starts_with("std::optional<")) return;
    const std::vector<int> variables = visibleVariables(tree, index);
    std::vector<std::string> limits;
    for (const int variable : variables) {
        const Node& one = tree.at(variable);
        if (one.type == "double") limits.push_back(one.name);
        if (one.type == "raytracer::Vector3") limits.push_back(one.name + ".magnitude()");
    }
    for (const int variable : variables) {
        const Node& hit = tree.at(variable);
        if (hit.name != asked.name || !hit.isOptional) continue;
        for (const Quantity& part : hit.parts)
            for (const std::string& limit : limits) {
                if (part.type != "double") continue;
                const std::string number = hit.name + part.text;
                edits.add("limit", index,
                          {{node.range,
                            isNegated ? "(!" + hit.name + " || " + number + " > " + limit + ")"
                                      : "(" + hit.name + " && " + number + " < " + limit + ")"}});
            }
    }
}

}  // namespace

void addWideEdits(Edits& edits, int index) {
    const Node& node = edits.tree().at(index);
    addLimits(edits, index);
    if (node.isExpression && edits.text(index) == "nullptr")
        edits.add("word", edits.tree().topOf(index), {{node.range, "this"}});
    if (!node.isExpression || node.kind == NodeKind::parentheses || isCounting(node)) return;
    if (node.parent >= 0 && isCounting(edits.tree().at(node.parent))) return;
    if (!edits.isNumber(index) && !edits.isVector(index)) return;
    const Vocabulary words{edits, index};
    addReplacements(edits, index, words);
    if (edits.isInteger(index) || node.parent < 0 || !isTerm(edits, index)) return;
    if (node.kind != NodeKind::number) addFactors(edits, index, words);
    if (!edits.isType(index, "raytracer::Vector3")) return;
    addTerms(edits, index, words);
    addSteps(edits, index, words);
}

void addGuards(Edits& edits, int index) {
    // A number that must be positive, or must not be negative, before what follows.
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    const int function = tree.functionOf(index);
    const bool isNumber = node.kind == NodeKind::declaration && node.type == "double";
    if (!isNumber || function < 0 || !tree.at(function).returnsOptional) return;
    const int statement = tree.statementOf(index);
    if (tree.at(tree.at(statement).parent).kind != NodeKind::block) return;
    const auto& all = tree.at(tree.at(statement).parent).children;
    const auto next = std::ranges::find(all, statement) + 1;
    if (next == all.end()) return;
    const std::size_t at = tree.at(*next).range.begin;
    for (const char* test : {" < 0.0", " <= 0.0"})
        edits.addBefore("guard", *next, {at, at}, "if (" + node.name + test + ") return {};\n    ");
}

}  // namespace ticker::candidates
