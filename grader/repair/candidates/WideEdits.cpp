#include <grader/repair/candidates/Atom.h>
#include <grader/repair/candidates/Vocabulary.h>
#include <grader/repair/candidates/WideTerms.h>

#include <algorithm>
#include <iterator>

namespace ticker::candidates {
namespace {

/// Whether a line ends between two places.
bool goesOn(const Edits& edits, std::size_t begin, std::size_t end) {
    return edits.source().in({begin, end}).find('\n') != std::string_view::npos;
}

/// Whether a node is the number that a direction is multiplied by.
bool isScale(const Edits& edits, int index) {
    const Node& around = edits.tree().at(edits.tree().at(index).parent);
    return around.kind == NodeKind::binary && around.name == "*" &&
           around.children.back() == index && edits.isType(index, "double") &&
           edits.isType(around.children.front(), "raytracer::Vector3");
}

/// Whether a term or a factor may be added to a node: it stands alone, is an operand of an operator
/// other than *, / and =, has a method called for it, is the number that a direction is multiplied
/// by, or is the first operand of a product or quotient that goes on in the next line.
bool isTerm(const Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const Node& node = tree.at(index);
    const Node& around = tree.at(node.parent);
    if (isScale(edits, index)) return true;
    if (around.kind == NodeKind::binary && (around.name == "*" || around.name == "/"))
        return around.children.front() == index && goesOn(edits, node.range.end, around.range.end);
    if (around.kind == NodeKind::binary) return around.name != "=";
    return around.kind == NodeKind::member || standsAlone(tree, index);
}

void addReplacements(Edits& edits, int index, const Vocabulary& words) {
    const Node& node = edits.tree().at(index);
    // A point may take more words: `lights.front().position()`.
    const std::size_t mostTokens = edits.isType(index, "raytracer::Vector3") ? 9 : 6;
    const bool isSmall = node.kind == NodeKind::number || node.kind == NodeKind::name ||
                         node.kind == NodeKind::member || node.kind == NodeKind::call ||
                         node.kind == NodeKind::unary ||
                         (node.kind == NodeKind::cast && edits.isVector(index));
    // A product may stand for the result of a function of the kit.
    const bool isNew = edits.tree().at(node.parent).kind == NodeKind::declaration;
    if (isNew && node.kind == NodeKind::binary && edits.isType(index, "raytracer::ColourRGB"))
        for (const std::string& call : words.calls(node.type))
            edits.replace("word", index, call, true);
    if (!isSmall || edits.source().tokensIn(node.range).size() > mostTokens) return;
    const bool isPoint = edits.isType(index, "raytracer::Vector3");
    for (const std::string& word : isPoint ? words.points() : words.all(node.type))
        edits.replace("word", index, word, true);
    if (edits.isType(index, "double"))
        for (const std::string& length : words.lengths())
            edits.replace("word", index, length, true);
    if (edits.isInteger(index) && node.kind == NodeKind::number)
        for (const std::string& word : words.variables("int"))
            for (const char* step : {" - 1", " + 1"})
                edits.replace("word", index, word + step, false);
    if (edits.isType(index, "double") && node.kind == NodeKind::number)
        for (const std::string& word : words.unused("int"))
            edits.replace("word", index, word, true);
}

void addFactors(Edits& edits, int index, const Vocabulary& words) {
    const Node& node = edits.tree().at(index);
    const bool isProduct = node.kind == NodeKind::binary && (node.name == "*" || node.name == "/");
    const std::string operand = isProduct ? edits.text(index) : edits.operand(index);
    const Node& around = edits.tree().at(node.parent);
    const bool isFactor = around.name == "*" || around.name == "/";
    const bool holds =
        around.kind == NodeKind::binary && (!isFactor || around.children.front() == index);
    const bool isPoint = edits.isType(index, "raytracer::Vector3");
    std::vector<std::string> factors = isPoint ? words.unused("double") : words.all("double");
    if (edits.isType(index, "raytracer::ColourRGB"))
        std::ranges::move(words.colours(), std::back_inserter(factors));
    // The rest of a share: 1 - share.
    if (edits.isType(index, "raytracer::ColourRGB"))
        for (const std::string& share : words.variables("double"))
            factors.push_back("(1.0 - " + share + ")");
    if (isPoint) factors.emplace_back("2.0");
    if (edits.isType(index, "double")) factors.emplace_back("4.0");
    // The square of a value that a function returns, such as a length.
    if (edits.isType(index, "double") && node.kind == NodeKind::call)
        edits.replace("factor", index, operand + " * " + operand, holds);
    for (const std::string& factor : factors)
        if (factor != edits.text(index))
            edits.replace("factor", index, operand + " * " + factor, holds);
    if (isPoint || !(standsAlone(edits.tree(), index) || isScale(edits, index))) return;
    if (edits.isType(index, "double"))
        for (const std::string& point : words.places())
            for (const char* axis : {".x", ".y", ".z"})
                edits.replace("factor", index, operand + " / " + point + axis, false);
    for (const char* type : {"double", "int"})
        for (const std::string& factor : words.all(type))
            if (factor != edits.text(index))
                edits.replace("factor", index, operand + " / " + factor, holds);
}

/// Replaces a divisor by a component of a point or direction, as in the distance to a plane.
void addDivisors(Edits& edits, int index, const Vocabulary& words) {
    const Node& node = edits.tree().at(index);
    const Node& around = edits.tree().at(node.parent);
    const bool divides =
        around.kind == NodeKind::binary && around.name == "/" && around.children.back() == index;
    if (!divides || node.kind == NodeKind::number || !edits.isType(index, "double")) return;
    for (const std::string& point : words.places())
        for (const char* axis : {".x", ".y", ".z"})
            edits.replace("word", index, point + axis, true);
}

/// A point that is moved a little along a direction.
void addSteps(Edits& edits, int index, const Vocabulary& words) {
    constexpr std::size_t kMostTokens = 6;
    const Node& node = edits.tree().at(index);
    if (!standsAlone(edits.tree(), index)) return;
    if (edits.source().tokensIn(node.range).size() > kMostTokens) return;
    const std::vector<std::string> variables = words.variables("raytracer::Vector3");
    std::vector<std::string> starts = variables;
    std::vector<std::string> lengths = words.constants();
    if (node.kind == NodeKind::name) {
        starts = {edits.text(index)};
        lengths = words.unused("double");
    }
    for (const std::string& start : starts)
        for (const std::string& along : variables)
            for (const std::string& length : lengths)
                if (along != start)
                    edits.replace("step", index, start + " + " + along + " * " + length, false);
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

/// Puts in values that the function computes but does not use, and angles as shares of a turn.
void addIdle(Edits& edits, int index, const Vocabulary& words) {
    const Node& node = edits.tree().at(index);
    constexpr std::size_t kMostTokens = 16;
    if (!standsAlone(edits.tree(), index)) return;
    if (edits.source().tokensIn(node.range).size() > kMostTokens) return;
    for (const std::string& word : words.idle(node.type))
        edits.replace("word", index, word, true);
    if (!edits.isType(index, "double") ||
        edits.tree().at(node.parent).kind != NodeKind::declaration)
        return;
    for (const std::string& angle : words.angles()) {
        edits.replace("word", index, angle + " / std::numbers::pi", false);
        edits.replace("word", index, angle + " / (2.0 * std::numbers::pi) + 0.5", false);
    }
}

/// One of two roots: the first if it is positive, the smaller, the larger.
void addChoices(Edits& edits, int index, const Vocabulary& words) {
    const Node& node = edits.tree().at(index);
    constexpr std::size_t kMostTokens = 12;
    const bool isNew = edits.tree().at(node.parent).kind == NodeKind::declaration;
    if (!isNew || !edits.isType(index, "double")) return;
    if (edits.source().tokensIn(node.range).size() > kMostTokens) return;
    for (const auto& [one, other] : words.twins()) {
        edits.replace("choice", index, one + " > 0.0 ? " + one + " : " + other, false);
        edits.replace("choice", index, other + " > 0.0 ? " + other + " : " + one, false);
        edits.replace("choice", index, "std::min(" + one + ", " + other + ")", true);
        edits.replace("choice", index, "std::max(" + one + ", " + other + ")", true);
    }
}

/// Wraps a value in a square root, an absolute value or an arc tangent.
void addFunctions(Edits& edits, int index) {
    if (!edits.isType(index, "double") || !standsAlone(edits.tree(), index)) return;
    const Node& node = edits.tree().at(index);
    if (node.kind == NodeKind::number || node.name == "sqrt" || node.name == "abs") return;
    for (const char* function : {"std::sqrt(", "std::abs(", "std::atan("})
        edits.replace("wrap", index, function + edits.bareText(index) + ")", true);
}

}  // namespace

void addWideEdits(Edits& edits, int index) {
    const Node& node = edits.tree().at(index);
    addHitEdits(edits, index);
    if (node.isExpression && edits.text(index) == "nullptr")
        edits.add("word", edits.tree().topOf(index), {{node.range, "this"}});
    if (!node.isExpression || node.kind == NodeKind::parentheses || isCounting(node)) return;
    if (node.parent >= 0 && isCounting(edits.tree().at(node.parent))) return;
    if (!edits.isNumber(index) && !edits.isVector(index)) return;
    const Vocabulary words{edits, index};
    addReplacements(edits, index, words);
    addDivisors(edits, index, words);
    addIdle(edits, index, words);
    addChoices(edits, index, words);
    addFunctions(edits, index);
    addWideTerms(edits, index, words);
    if (edits.isInteger(index) || node.parent < 0 || !isTerm(edits, index)) return;
    if (node.kind != NodeKind::number) addFactors(edits, index, words);
    if (!edits.isType(index, "raytracer::Vector3")) return;
    addTerms(edits, index, words);
    addSteps(edits, index, words);
}

void addGuards(Edits& edits, int index) {
    // Adds `return {}` for a number that is negative, or not positive, before the next statement.
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
