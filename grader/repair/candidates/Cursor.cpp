#include <grader/repair/candidates/Cursor.h>

namespace ticker::candidates {

std::string textOf(CXString text) {
    const char* chars = clang_getCString(text);
    std::string copy = chars == nullptr ? "" : chars;
    clang_disposeString(text);
    return copy;
}

namespace {

std::string& removePrefix(std::string& text, std::string_view prefix) {
    if (text.starts_with(prefix)) text.erase(0, prefix.size());
    return text;
}

unsigned offsetOf(CXSourceLocation location) {
    unsigned offset = 0;
    clang_getExpansionLocation(location, nullptr, nullptr, nullptr, &offset);
    return offset;
}

CXFile mainFileOf(CXTranslationUnit unit) {
    return clang_getFile(unit, textOf(clang_getTranslationUnitSpelling(unit)).c_str());
}

/// Whether the student's own file has it, be it as the name of a macro: M_PI, RAND_MAX. No line and
/// column are asked for: libclang counts characters for each, and lines with many switches are
/// long.
bool standsHere(CXCursor cursor, CXSourceLocation location) {
    if (clang_Location_isFromMainFile(location) != 0) return true;
    CXFile file = nullptr;
    clang_getExpansionLocation(location, &file, nullptr, nullptr, nullptr);
    return file != nullptr &&
           clang_File_isEqual(file, mainFileOf(clang_Cursor_getTranslationUnit(cursor))) != 0;
}

/// What a field holds or a function without arguments returns; empty for any other cursor.
std::string givenType(CXCursor declaration) {
    const CXCursorKind kind = clang_getCursorKind(declaration);
    if (kind == CXCursor_FieldDecl) return plainType(clang_getCursorType(declaration));
    if (kind != CXCursor_CXXMethod || clang_Cursor_getNumArguments(declaration) != 0 ||
        clang_CXXMethod_isStatic(declaration) != 0)
        return {};
    return plainType(clang_getCursorResultType(declaration));
}

}  // namespace

std::optional<Range> rangeOf(CXCursor cursor) {
    const CXSourceRange extent = clang_getCursorExtent(cursor);
    const CXSourceLocation begin = clang_getRangeStart(extent);
    const CXSourceLocation end = clang_getRangeEnd(extent);
    if (!standsHere(cursor, begin)) return std::nullopt;
    const Range range{offsetOf(begin), offsetOf(end)};
    if (range.end <= range.begin) return std::nullopt;
    return range;
}

bool isWrittenOut(CXCursor cursor) {
    const CXSourceRange extent = clang_getCursorExtent(cursor);
    for (const CXSourceLocation place : {clang_getRangeStart(extent), clang_getRangeEnd(extent)}) {
        unsigned spelled = 0;
        clang_getSpellingLocation(place, nullptr, nullptr, nullptr, &spelled);
        if (spelled != offsetOf(place)) return false;
    }
    return true;
}

std::vector<CXCursor> childrenOf(CXCursor cursor) {
    std::vector<CXCursor> children;
    clang_visitChildren(
        cursor,
        [](CXCursor child, CXCursor, CXClientData data) {
            static_cast<std::vector<CXCursor>*>(data)->push_back(child);
            return CXChildVisit_Continue;
        },
        &children);
    return children;
}

std::string plainType(CXType type) {
    const CXType pointee = clang_getPointeeType(type);
    const bool isReference =
        type.kind == CXType_LValueReference || type.kind == CXType_RValueReference;
    std::string text =
        textOf(clang_getTypeSpelling(clang_getCanonicalType(isReference ? pointee : type)));
    return removePrefix(text, "const ");
}

CXCursor withoutConversions(CXCursor cursor) {
    while (true) {
        const CXCursorKind kind = clang_getCursorKind(cursor);
        if (kind != CXCursor_UnexposedExpr && kind != CXCursor_CallExpr) return cursor;
        const std::vector<CXCursor> children = childrenOf(cursor);
        if (children.size() != 1 || rangeOf(children.front()) != rangeOf(cursor)) return cursor;
        cursor = children.front();
    }
}

std::vector<std::string> siblingsOf(CXCursor member) {
    const CXCursor declaration = clang_getCursorReferenced(member);
    const std::string own = textOf(clang_getCursorSpelling(declaration));
    const std::string type = givenType(declaration);
    std::vector<std::string> names;
    if (type.empty()) return names;
    for (const CXCursor& other : childrenOf(clang_getCursorSemanticParent(declaration))) {
        if (clang_getCursorKind(other) != clang_getCursorKind(declaration) ||
            clang_getCXXAccessSpecifier(other) != CX_CXXPublic || givenType(other) != type)
            continue;
        std::string name = textOf(clang_getCursorSpelling(other));
        if (name != own && !name.starts_with("operator")) names.push_back(std::move(name));
    }
    return names;
}

NodeKind kindOf(CXCursorKind kind) {
    switch (kind) {
        case CXCursor_CompoundStmt:
            return NodeKind::block;
        case CXCursor_ForStmt:
        case CXCursor_WhileStmt:
        case CXCursor_DoStmt:
        case CXCursor_CXXForRangeStmt:
            return NodeKind::loop;
        case CXCursor_ContinueStmt:
        case CXCursor_BreakStmt:
        case CXCursor_ReturnStmt:
            return NodeKind::jump;
        case CXCursor_IfStmt:
            return NodeKind::branch;
        case CXCursor_VarDecl:
            return NodeKind::declaration;
        case CXCursor_FunctionDecl:
        case CXCursor_CXXMethod:
        case CXCursor_LambdaExpr:
            return NodeKind::function;
        case CXCursor_MemberRefExpr:
            return NodeKind::member;
        case CXCursor_CallExpr:
            return NodeKind::call;
        case CXCursor_BinaryOperator:
        case CXCursor_CompoundAssignOperator:
            return NodeKind::binary;
        case CXCursor_UnaryOperator:
            return NodeKind::unary;
        case CXCursor_ParenExpr:
            return NodeKind::parentheses;
        case CXCursor_InitListExpr:
            return NodeKind::list;
        case CXCursor_IntegerLiteral:
        case CXCursor_FloatingLiteral:
            return NodeKind::number;
        case CXCursor_CXXStaticCastExpr:
        case CXCursor_CStyleCastExpr:
        case CXCursor_CXXFunctionalCastExpr:
            return NodeKind::cast;
        default:
            break;
    }
    if (clang_isExpression(kind) != 0) return NodeKind::expression;
    return clang_isStatement(kind) != 0 ? NodeKind::statement : NodeKind::other;
}

}  // namespace ticker::candidates
