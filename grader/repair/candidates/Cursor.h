#ifndef TICKER_REPAIR_CANDIDATES_CURSOR_H
#define TICKER_REPAIR_CANDIDATES_CURSOR_H

#include <grader/repair/candidates/Tree.h>

#include <clang-c/Index.h>

#include <optional>
#include <string>
#include <vector>

namespace ticker::candidates {

[[nodiscard]] NodeKind kindOf(CXCursorKind kind);
/// libclang's text as one of the C++ library.
[[nodiscard]] std::string textOf(CXString text);
/// Where a cursor stands in the student's file; empty if it stands elsewhere.
[[nodiscard]] std::optional<Range> rangeOf(CXCursor cursor);
/// Whether the cursor's text stands in the file, and does not come from a macro.
[[nodiscard]] bool isWrittenOut(CXCursor cursor);
[[nodiscard]] std::vector<CXCursor> childrenOf(CXCursor cursor);
/// The canonical name of a type, without const and reference.
[[nodiscard]] std::string plainType(CXType type);
/// The same cursor without conversions and copies that stand in no text.
[[nodiscard]] CXCursor withoutConversions(CXCursor cursor);
/// Names of the class's other public members of the same kind and type as a member: fields, or
/// functions without arguments.
[[nodiscard]] std::vector<std::string> siblingsOf(CXCursor member);

/// What members of a variable of this type give: `.colour()` of an object, `->distance` of an
/// optional hit. Numbers, points and colours alone.
[[nodiscard]] std::vector<Quantity> partsOf(CXType type);
/// What a method's own class gives: `radius()`, `settings().rays`.
[[nodiscard]] std::vector<Quantity> ownPartsOf(CXCursor method);
/// Constants of a namespace of the kit.
[[nodiscard]] std::vector<Quantity> constantsOf(CXCursor kitNamespace);
[[nodiscard]] bool isOptional(CXType type);

}  // namespace ticker::candidates

#endif
