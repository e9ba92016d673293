#include <grader/repair/candidates/Atom.h>

#include <algorithm>

namespace ticker::candidates {
namespace {

/// continue, break and return in each other's place.
void exchangeJumps(Edits& edits, int index) {
    if (loopAround(edits.tree(), index) < 0) return;
    for (const char* jump : {"continue;", "break;"})
        edits.addInstead("jump", index, wholeOf(edits, index), jump);
}

/// A statement that declares nothing, nothing after it needs, and that may be left out.
bool mayBeLeftOut(const Tree& tree, int index) {
    const Node& node = tree.at(index);
    if (node.parent < 0 || tree.at(node.parent).kind != NodeKind::block) return false;
    if (node.kind == NodeKind::branch || node.kind == NodeKind::loop) return true;
    return node.isExpression;
}

/// Whether a variable of type int is initialised with a double without a written cast.
bool isCutOff(const Edits& edits, const Node& declaration) {
    if (declaration.isAuto || declaration.type != "int" || declaration.children.empty())
        return false;
    return edits.isType(declaration.children.back(), "double");
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
        // A copy for every call may cost more time than there is.
        if (node.type.starts_with("raytracer::") && !edits.isVector(index))
            edits.addApart("static", index, {drop, {{node.declared - 1, node.declared}, "& "}});
        edits.addApart("static", index, {drop});
    }
}

void addStatementEdits(Edits& edits, int index) {
    const Node& node = edits.tree().at(index);
    if (node.kind == NodeKind::declaration && isCutOff(edits, node))
        for (const Range& token : edits.source().tokensIn(node.range))
            if (edits.source().in(token) == "int" && token.begin < node.declared)
                edits.addApart("type", index, {{token, "double"}});
    if (node.kind == NodeKind::jump) exchangeJumps(edits, index);
    if (mayBeLeftOut(edits.tree(), index))
        edits.addInstead("left-out", index, wholeOf(edits, index), "");
}

}  // namespace ticker::candidates
