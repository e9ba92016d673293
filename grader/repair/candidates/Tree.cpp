#include <grader/repair/candidates/Cursor.h>
#include <grader/repair/candidates/Tree.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>
#include <utility>

namespace ticker::candidates {
namespace {

/// Copies libclang's tree.
class Copy {
public:
    Copy(Tree& tree, const Source& source) : tree_(tree), source_(source) {}

    void add(CXCursor cursor, int parent) {
        cursor = withoutConversions(cursor);
        const std::optional<Range> range = rangeOf(cursor);
        if (!range || clang_isReference(clang_getCursorKind(cursor)) != 0) return;
        const int index = static_cast<int>(tree_.nodes.size());
        tree_.nodes.push_back(describe(cursor, *range, parent));
        if (parent >= 0) tree_.nodes[static_cast<std::size_t>(parent)].children.push_back(index);
        if (!tree_.at(index).isWritten) return;
        for (const CXCursor& child : childrenOf(cursor))
            add(child, index);
        refine(index);
    }

private:
    [[nodiscard]] static Node describe(CXCursor cursor, const Range& range, int parent) {
        const CXCursorKind kind = clang_getCursorKind(cursor);
        Node node;
        node.kind = kindOf(kind);
        node.range = range;
        node.parent = parent;
        node.isExpression = clang_isExpression(kind) != 0;
        node.isWritten = isWrittenOut(cursor);
        node.name = textOf(clang_getCursorSpelling(cursor));
        if (node.isExpression || node.kind == NodeKind::declaration || kind == CXCursor_ParmDecl)
            node.type = plainType(clang_getCursorType(cursor));
        if (kind == CXCursor_DeclRefExpr) describeName(cursor, node);
        if (node.kind == NodeKind::member) node.siblings = siblingsOf(cursor);
        if (node.kind == NodeKind::declaration || kind == CXCursor_ParmDecl) {
            node.declared = placeOf(cursor);
            node.parts = partsOf(clang_getCursorType(cursor));
            node.isOptional = isOptional(clang_getCursorType(cursor));
        }
        if (node.kind == NodeKind::function) {
            node.parts = ownPartsOf(cursor);
            node.returnsOptional = isOptional(clang_getCursorResultType(cursor));
        }
        if (node.kind == NodeKind::declaration) describeStorage(cursor, node);
        return node;
    }

    static std::size_t placeOf(CXCursor declaration) {
        const CXSourceLocation place = clang_getCursorLocation(declaration);
        if (clang_Location_isFromMainFile(place) == 0) return 0;
        unsigned offset = 0;
        clang_getExpansionLocation(place, nullptr, nullptr, nullptr, &offset);
        return offset;
    }

    static void describeName(CXCursor cursor, Node& node) {
        const CXCursor declaration = clang_getCursorReferenced(cursor);
        const CXCursorKind kind = clang_getCursorKind(declaration);
        if (kind != CXCursor_VarDecl && kind != CXCursor_ParmDecl) return;
        node.kind = NodeKind::name;
        node.declared = placeOf(declaration);
    }

    static void describeStorage(CXCursor cursor, Node& node) {
        const CXCursorKind around = clang_getCursorKind(clang_getCursorSemanticParent(cursor));
        const bool isGlobal = around == CXCursor_Namespace || around == CXCursor_TranslationUnit;
        const bool isConst = clang_isConstQualifiedType(clang_getCursorType(cursor)) != 0;
        node.isStatic = clang_Cursor_hasVarDeclGlobalStorage(cursor) != 0 ||
                        clang_getCursorTLSKind(cursor) != CXTLS_None;
        node.isConstant = isGlobal && isConst;
    }

    /// Operators of classes look like calls, whose second part is the operator's name.
    void refine(int index) {
        Node& node = tree_.nodes[static_cast<std::size_t>(index)];
        if (node.kind == NodeKind::call && node.name.starts_with("operator")) {
            std::erase_if(node.children, [&](int child) {
                return tree_.at(child).name.starts_with("operator") &&
                       tree_.at(child).children.empty();
            });
            node.kind = node.children.size() == 2   ? NodeKind::binary
                        : node.children.size() == 1 ? NodeKind::unary
                                                    : NodeKind::expression;
            if (node.name == "operator[]") node.kind = NodeKind::expression;
            // Of a lambda, say: what is called comes first here, too.
            if (node.name == "operator()") node.kind = NodeKind::call;
        }
        // `Vector3 v{a, b}`: the constructor's text is the variable's name and the list.
        if (node.kind == NodeKind::call && node.parent >= 0 &&
            tree_.at(node.parent).declared == node.range.begin)
            node.isExpression = false;
        if (node.kind == NodeKind::binary) nameOperator(node);
        if (node.kind == NodeKind::unary) node.name = firstToken(node);
        if (node.kind == NodeKind::declaration) {
            for (const Range& token : source_.tokensIn(node.range)) {
                if (token.begin >= node.declared) break;
                node.isAuto = node.isAuto || source_.in(token) == "auto";
                node.isConstant = node.isConstant || source_.in(token) == "constexpr";
            }
        }
    }

    [[nodiscard]] std::string firstToken(const Node& node) const {
        const auto tokens = source_.tokensIn(node.range);
        return tokens.empty() ? "" : std::string{source_.in(tokens.front())};
    }

    void nameOperator(Node& node) const {
        if (node.children.size() != 2) {
            node.kind = NodeKind::expression;
            return;
        }
        const Range between{tree_.at(node.children[0]).range.end,
                            tree_.at(node.children[1]).range.begin};
        const auto tokens =
            between.begin < between.end ? source_.tokensIn(between) : std::vector<Range>{};
        if (tokens.size() == 1)
            node.name = source_.in(tokens.front());
        else
            node.kind = NodeKind::expression;
    }

    Tree& tree_;
    const Source& source_;
};

using Unit = std::unique_ptr<CXTranslationUnitImpl, decltype(&clang_disposeTranslationUnit)>;
using Index = std::unique_ptr<void, decltype(&clang_disposeIndex)>;

void readDiagnostics(CXTranslationUnit unit, Tree& tree) {
    for (unsigned i = 0; i < clang_getNumDiagnostics(unit); ++i) {
        CXDiagnostic said = clang_getDiagnostic(unit, i);
        Diagnostic diagnostic;
        const CXSourceLocation place = clang_getDiagnosticLocation(said);
        unsigned offset = 0;
        clang_getExpansionLocation(place, nullptr, nullptr, nullptr, &offset);
        diagnostic.offset = offset;
        diagnostic.isError = clang_getDiagnosticSeverity(said) >= CXDiagnostic_Error;
        diagnostic.text = textOf(clang_getDiagnosticSpelling(said));
        tree.diagnostics.push_back(std::move(diagnostic));
        clang_disposeDiagnostic(said);
    }
}

std::vector<const char*> asWords(const std::vector<std::string>& arguments) {
    std::vector<const char*> words;
    for (const std::string& argument : arguments)
        words.push_back(argument.c_str());
    return words;
}

/// Whether there are errors; prints the first, which is the cause of the others.
bool saysErrors(CXTranslationUnit unit) {
    for (unsigned i = 0; i < clang_getNumDiagnostics(unit); ++i) {
        const std::unique_ptr<void, void (*)(CXDiagnostic)> found{clang_getDiagnostic(unit, i),
                                                                  &clang_disposeDiagnostic};
        if (clang_getDiagnosticSeverity(found.get()) < CXDiagnostic_Error) continue;
        std::cerr << textOf(clang_formatDiagnostic(found.get(),
                                                   clang_defaultDiagnosticDisplayOptions()))
                  << '\n';
        return true;
    }
    return false;
}

}  // namespace

int Tree::topOf(int index) const {
    while (at(index).parent >= 0 && at(at(index).parent).isExpression)
        index = at(index).parent;
    return index;
}

int Tree::statementOf(int index) const {
    const auto isStatement = [&](int i) {
        const NodeKind around = at(at(i).parent).kind;
        return around == NodeKind::block || around == NodeKind::loop ||
               around == NodeKind::function;
    };
    while (at(index).parent >= 0 && !isStatement(index))
        index = at(index).parent;
    return index;
}

int Tree::functionOf(int index) const {
    do
        index = at(index).parent;
    while (index >= 0 && at(index).kind != NodeKind::function);
    return index;
}

Tree Parser::parse(const std::string& file, const std::string& text) const {
    const Index index{clang_createIndex(0, 0), &clang_disposeIndex};
    CXUnsavedFile unsaved{file.c_str(), text.c_str(), text.size()};
    const std::vector<const char*> words = asWords(arguments_);
    const Unit unit{clang_parseTranslationUnit(index.get(), file.c_str(), words.data(),
                                               static_cast<int>(words.size()), &unsaved, 1,
                                               CXTranslationUnit_None),
                    &clang_disposeTranslationUnit};
    Tree tree;
    if (!unit) return tree;
    tree.wasParsed = true;
    readDiagnostics(unit.get(), tree);
    const Source source{text};
    Copy copy{tree, source};
    for (const CXCursor& top : childrenOf(clang_getTranslationUnitCursor(unit.get()))) {
        const bool isKit = clang_getCursorKind(top) == CXCursor_Namespace && !rangeOf(top) &&
                           textOf(clang_getCursorSpelling(top)) == "raytracer";
        if (isKit)
            std::ranges::move(constantsOf(top), std::back_inserter(tree.constants));
        else
            copy.add(top, -1);
    }
    return tree;
}

bool Parser::precompile(const std::string& header, const std::string& target) const {
    const Index index{clang_createIndex(0, 0), &clang_disposeIndex};
    const std::vector<const char*> words = asWords(arguments_);
    const Unit unit{
        clang_parseTranslationUnit(
            index.get(), header.c_str(), words.data(), static_cast<int>(words.size()), nullptr, 0,
            CXTranslationUnit_Incomplete | CXTranslationUnit_ForSerialization),
        &clang_disposeTranslationUnit};
    // libclang would save what it could read: a header without, say, Clang's own stddef.h.
    return unit && !saysErrors(unit.get()) &&
           clang_saveTranslationUnit(unit.get(), target.c_str(),
                                     clang_defaultSaveOptions(unit.get())) == 0;
}

}  // namespace ticker::candidates
