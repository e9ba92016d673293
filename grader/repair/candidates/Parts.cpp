#include <grader/repair/candidates/Cursor.h>

#include <set>

namespace ticker::candidates {
namespace {

bool isWanted(const std::string& type) {
    static const std::set<std::string> kTypes{"int", "double", "raytracer::Vector3",
                                              "raytracer::ColourRGB"};
    return kTypes.contains(type);
}

bool isPublic(CXCursor cursor) {
    return clang_getCXXAccessSpecifier(cursor) == CX_CXXPublic;
}

/// A field, or a function that can be called without arguments and changes nothing.
std::optional<CXType> typeOfMember(CXCursor cursor) {
    const CXCursorKind kind = clang_getCursorKind(cursor);
    if (kind == CXCursor_FieldDecl) return clang_getCursorType(cursor);
    if (kind != CXCursor_CXXMethod || clang_Cursor_getNumArguments(cursor) != 0 ||
        clang_CXXMethod_isStatic(cursor) != 0 || clang_CXXMethod_isConst(cursor) == 0)
        return std::nullopt;
    return clang_getCursorResultType(cursor);
}

std::string callOf(CXCursor member) {
    const std::string name = textOf(clang_getCursorSpelling(member));
    return clang_getCursorKind(member) == CXCursor_FieldDecl ? name : name + "()";
}

CXType withoutReference(CXType type) {
    const bool isReference =
        type.kind == CXType_LValueReference || type.kind == CXType_RValueReference;
    return isReference ? clang_getPointeeType(type) : type;
}

using Use = void (*)(CXCursor member, CXType type, const std::string& before,
                     std::vector<Quantity>& found);

/// Members of a class and of its bases.
void forMembers(CXCursor record, bool alsoProtected, const std::string& before, Use use,
                std::vector<Quantity>& found) {
    for (const CXCursor& child : childrenOf(record)) {
        if (clang_getCursorKind(child) == CXCursor_CXXBaseSpecifier) {
            forMembers(clang_getTypeDeclaration(clang_getCursorType(child)), alsoProtected, before,
                       use, found);
            continue;
        }
        const auto type = typeOfMember(child);
        const bool isSeen =
            isPublic(child) ||
            (alsoProtected && clang_getCXXAccessSpecifier(child) == CX_CXXProtected);
        const bool isNamed = !textOf(clang_getCursorSpelling(child)).starts_with("operator");
        if (type && isSeen && isNamed) use(child, withoutReference(*type), before, found);
    }
}

void addPlain(CXCursor member, CXType type, const std::string& before,
              std::vector<Quantity>& found) {
    if (const std::string plain = plainType(type); isWanted(plain))
        found.push_back({before + callOf(member), plain, ""});
}

bool isHit(const std::string& type) {
    return type.starts_with("std::optional<raytracer::");
}

/// A function of one argument that changes nothing: `.evaluateAt`, `.findClosestIntersection`.
void addMethod(CXCursor member, const std::string& before, std::vector<Quantity>& found) {
    if (clang_getCursorKind(member) != CXCursor_CXXMethod || !isPublic(member) ||
        clang_Cursor_getNumArguments(member) != 1 || clang_CXXMethod_isStatic(member) != 0 ||
        clang_CXXMethod_isConst(member) == 0)
        return;
    const std::string name = textOf(clang_getCursorSpelling(member));
    const std::string type = plainType(clang_getCursorResultType(member));
    const std::string argument =
        plainType(clang_getCursorType(clang_Cursor_getArgument(member, 0)));
    const bool isAsked = isHit(type) && argument.starts_with("raytracer::");
    if ((isAsked || (isWanted(type) && isWanted(argument))) && !name.starts_with("operator"))
        found.push_back({before + name, type, argument});
}

/// Such functions of a class and of its bases.
void addMethods(CXCursor record, const std::string& before, std::vector<Quantity>& found) {
    for (const CXCursor& child : childrenOf(record))
        if (clang_getCursorKind(child) == CXCursor_CXXBaseSpecifier)
            addMethods(clang_getTypeDeclaration(clang_getCursorType(child)), before, found);
        else
            addMethod(child, before, found);
}

/// A number, or the numbers of a class of the kit that is no vector itself.
void addDeep(CXCursor member, CXType type, const std::string& before,
             std::vector<Quantity>& found) {
    if (isWanted(plainType(type)))
        addPlain(member, type, before, found);
    else if (plainType(type).starts_with("raytracer::"))
        forMembers(clang_getTypeDeclaration(type), false, before + callOf(member) + ".", addPlain,
                   found);
}

}  // namespace

bool isOptional(CXType type) {
    return plainType(type).starts_with("std::optional<");
}

std::vector<Quantity> partsOf(CXType type) {
    std::vector<Quantity> found;
    const CXType plain = clang_getCanonicalType(withoutReference(type));
    const bool isMaybe = isOptional(plain);
    const CXType inner =
        isMaybe ? clang_getCanonicalType(clang_Type_getTemplateArgumentAsType(plain, 0)) : plain;
    if (!plainType(inner).starts_with("raytracer::")) return found;
    const bool isVector = isWanted(plainType(inner));
    forMembers(clang_getTypeDeclaration(inner), false, isMaybe ? "->" : ".",
               isVector ? addPlain : addDeep, found);
    if (isVector)
        std::erase_if(found, [](const Quantity& part) { return part.type == "int"; });
    else
        addMethods(clang_getTypeDeclaration(inner), isMaybe ? "->" : ".", found);
    return found;
}

std::vector<Quantity> ownPartsOf(CXCursor method) {
    std::vector<Quantity> found;
    if (clang_getCursorKind(method) != CXCursor_CXXMethod) return found;
    forMembers(clang_getCursorSemanticParent(method), true, "", addDeep, found);
    addMethods(clang_getCursorSemanticParent(method), "", found);
    // A function that calls itself may never return.
    const std::string own = textOf(clang_getCursorSpelling(method));
    std::erase_if(found, [&](const Quantity& part) { return part.text == own; });
    return found;
}

std::vector<Quantity> constantsOf(CXCursor kitNamespace) {
    std::vector<Quantity> found;
    for (const CXCursor& child : childrenOf(kitNamespace))
        if (clang_getCursorKind(child) == CXCursor_VarDecl && !rangeOf(child))
            addPlain(child, clang_getCursorType(child), "", found);
    for (Quantity& constant : found)
        if (constant.text.ends_with("()")) constant.text.resize(constant.text.size() - 2);
    return found;
}

}  // namespace ticker::candidates
