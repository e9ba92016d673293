#include <grader/repair/candidates/Atom.h>

#include <algorithm>
#include <optional>

namespace ticker::candidates {
namespace {

/// Replaces a continue, break or return within a loop by continue and by break.
void exchangeJumps(Edits& edits, int index) {
    if (loopAround(edits.tree(), index) < 0) return;
    for (const char* jump : {"continue;", "break;"})
        edits.addInstead("jump", index, wholeOf(edits, index), jump);
}

/// Whether a statement may be left out: a branch, a loop or an expression, since these declare
/// nothing that later statements need.
bool mayBeLeftOut(const Tree& tree, int index) {
    const Node& node = tree.at(index);
    if (node.parent < 0 || tree.at(node.parent).kind != NodeKind::block) return false;
    if (node.kind == NodeKind::branch || node.kind == NodeKind::loop) return true;
    return node.isExpression;
}

/// Whether a variable is handed to a function, such as a column to the map's `at`.
bool isArgument(const Tree& tree, const Node& declaration) {
    return std::ranges::any_of(tree.nodes, [&](const Node& one) {
        return one.kind == NodeKind::name && one.declared == declaration.declared &&
               one.parent >= 0 && tree.at(one.parent).kind == NodeKind::call;
    });
}

/// Whether a variable of type int is initialised with a double without a written cast, and no
/// function needs the whole number.
bool isCutOff(const Edits& edits, const Node& declaration) {
    if (declaration.isAuto || declaration.type != "int" || declaration.children.empty())
        return false;
    return edits.isType(declaration.children.back(), "double") &&
           !isArgument(edits.tree(), declaration);
}

/// The word int of a declaration.
std::optional<Range> typeOf(const Edits& edits, const Node& declaration) {
    for (const Range& token : edits.source().tokensIn(declaration.range))
        if (edits.source().in(token) == "int" && token.begin < declaration.declared) return token;
    return std::nullopt;
}

/// The declaration of the next statement; -1: that is something else.
int nextDeclaration(const Tree& tree, int index) {
    const int statement = tree.statementOf(index);
    const int around = tree.at(statement).parent;
    if (around < 0) return -1;
    const auto& all = tree.at(around).children;
    const auto next = std::ranges::find(all, statement) + 1;
    if (next == all.end()) return -1;
    for (int i = *next; i < static_cast<int>(tree.nodes.size()); ++i) {
        if (!tree.at(*next).range.holds(tree.at(i).range)) break;
        if (tree.at(i).kind == NodeKind::declaration) return i;
    }
    return -1;
}

/// Makes a variable of type int a double if it cuts off fractions; and the next one with it, such
/// as the other slope of a point.
void keepFractions(Edits& edits, int index) {
    const Tree& tree = edits.tree();
    const auto type = typeOf(edits, tree.at(index));
    if (!type || !isCutOff(edits, tree.at(index))) return;
    edits.addApart("type", index, {{*type, "double"}});
    const int next = nextDeclaration(tree, index);
    if (next < 0 || !isCutOff(edits, tree.at(next))) return;
    if (const auto other = typeOf(edits, tree.at(next)))
        edits.addApart("type", tree.at(tree.statementOf(index)).parent,
                       {{*type, "double"}, {*other, "double"}});
}

}  // namespace

Range wholeOf(const Edits& edits, int statement) {
    Range range = edits.tree().at(statement).range;
    const std::string& text = edits.source().text();
    const std::size_t next = text.find_first_not_of(" \t\r\n", range.end);
    if (next != std::string::npos && text[next] == ';') range.end = next + 1;
    return range;
}

int loopAround(const Tree& tree, int statement) {
    for (int at = tree.at(statement).parent; at >= 0; at = tree.at(at).parent) {
        if (tree.at(at).kind == NodeKind::loop) return at;
        if (tree.at(at).kind == NodeKind::function) return -1;
    }
    return -1;
}

void addStaticEdits(Edits& edits, int index) {
    const Node& node = edits.tree().at(index);
    if (node.kind != NodeKind::declaration || !node.isStatic || node.isConstant) return;
    for (const Range& token : edits.source().tokensIn(node.range)) {
        if (token.begin >= node.declared) break;
        const std::string_view word = edits.source().in(token);
        if (word != "static" && word != "thread_local") continue;
        const Replacement drop{{token.begin, token.end + 1}, ""};
        // A copy in every call may take too long, so a reference is tried, too.
        if (node.type.starts_with("raytracer::") && !edits.isVector(index))
            edits.addApart("static", index, {drop, {{node.declared - 1, node.declared}, "& "}});
        edits.addApart("static", index, {drop});
    }
}

void addStatementEdits(Edits& edits, int index) {
    const Node& node = edits.tree().at(index);
    if (node.kind == NodeKind::declaration) keepFractions(edits, index);
    if (node.kind == NodeKind::jump) exchangeJumps(edits, index);
    if (mayBeLeftOut(edits.tree(), index))
        edits.addInstead("left-out", index, wholeOf(edits, index), "");
}

}  // namespace ticker::candidates
