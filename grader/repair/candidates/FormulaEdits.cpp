#include <grader/repair/candidates/Atom.h>
#include <grader/repair/candidates/Scope.h>
#include <grader/repair/candidates/Vocabulary.h>

#include <algorithm>

namespace ticker::candidates {
namespace {

constexpr const char* kKind = "formula";

/// The formula for each of the nearest variables that `@` may stand for.
std::vector<std::string> textsOf(const HandoutFormula& formula, const Vocabulary& words) {
    constexpr std::size_t kMost = 2;
    if (formula.of.empty()) return {formula.text};
    std::vector<std::string> texts;
    for (const std::string& name : words.variables(formula.of)) {
        if (texts.size() == kMost) break;
        std::string& text = texts.emplace_back();
        for (const char letter : formula.text)
            text += letter == '@' ? name : std::string{letter};
    }
    return texts;
}

/// Whether a formula asks for random numbers.
bool isRandom(const HandoutFormula& formula) {
    return formula.text.find("random") != std::string::npos;
}

/// Whether a node is a declaration with arguments of a constructor: `Vector3 v{a, b, c}`.
bool isConstructed(const Tree& tree, int index) {
    const Node& node = tree.at(index);
    return node.kind == NodeKind::declaration && !node.children.empty() &&
           !tree.at(node.children.back()).isExpression;
}

}  // namespace

void addFormulas(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const bool constructs = isConstructed(tree, index);
    if (!constructs && !isGiven(tree, index)) return;
    const Node& node = tree.at(index);
    if (std::ranges::find(edits.formulas(), node.type, &HandoutFormula::type) ==
        edits.formulas().end())
        return;
    const Vocabulary words{edits, index};
    const bool isDrawn = dependsOnDraws(tree, index);
    for (const HandoutFormula& formula : edits.formulas()) {
        if (formula.type != node.type || isRandom(formula) != isDrawn) continue;
        for (const std::string& text : textsOf(formula, words)) {
            const Range arguments{node.declared + node.name.size(), node.range.end};
            if (constructs)
                edits.addApart(kKind, index, {{arguments, " = " + text}});
            else
                edits.replace(kKind, index, text, true);
        }
    }
}

}  // namespace ticker::candidates
