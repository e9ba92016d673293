#ifndef TICKER_REPAIR_CANDIDATES_TREE_H
#define TICKER_REPAIR_CANDIDATES_TREE_H

#include <grader/repair/candidates/Tokens.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace ticker::candidates {

/// What a node of the tree is, as far as edits need it.
enum class NodeKind {
    other,
    block,        ///< { ... }
    statement,    ///< any other
    jump,         ///< continue, break, return
    branch,       ///< if: the condition, what follows, and perhaps what follows else
    loop,         ///< for, while, do: its body is the last child, or the first of a do
    declaration,  ///< of a variable, with its initialiser as the last child
    function,     ///< a function or a lambda
    name,         ///< of a variable or a parameter
    member,       ///< x.name, x.name of a function
    call,         ///< children: what is called, then the arguments
    binary,       ///< children: left, right; also of overloaded operators
    unary,        ///< child: the operand; also of overloaded operators
    parentheses,
    list,       ///< {a, b, c}
    number,     ///< a literal
    cast,       ///< written out
    expression  ///< any other
};

/// Something that an expression may name.
struct Quantity {
    std::string text;      ///< as it is written: "settings().rays", or ".colour()" behind a name
    std::string type;      ///< as of a node
    std::string argument;  ///< the type of its only argument, of a function; empty: none
};

/// A node of the student's own file; nodes that stand in no text, such as conversions, are left
/// out.
struct Node {
    NodeKind kind = NodeKind::other;
    Range range;
    std::string type;          ///< of an expression or a variable, canonical, without const and &
    std::string name;          ///< of a name, member, called function, operator or variable
    std::size_t declared = 0;  ///< of a name or declaration: offset of its declaration in this file
    int parent = -1;
    std::vector<int> children;
    bool isExpression = false;
    bool isWritten = true;    ///< false: stems from a macro
    bool isStatic = false;    ///< a declaration that keeps its value
    bool isConstant = false;  ///< a declaration of constexpr, or of const outside of functions
    bool isAuto = false;      ///< a declaration whose type follows from its initialiser
    std::vector<std::string> siblings;  ///< other members of the same class and type as this one
    std::vector<Quantity>
        parts;                ///< what its members are, of a variable; of a method: of its class
    bool isOptional = false;  ///< a variable of type std::optional
    bool returnsOptional = false;  ///< a function that does
};

/// ++ or --.
[[nodiscard]] inline bool isCounting(const Node& node) {
    return node.kind == NodeKind::unary && (node.name == "++" || node.name == "--");
}

/// ==, != or one of the four others.
[[nodiscard]] inline bool isComparison(const Node& node) {
    static constexpr std::array kNames{"==", "!=", "<", "<=", ">", ">="};
    return node.kind == NodeKind::binary && std::ranges::count(kNames, node.name) > 0;
}

struct Diagnostic {
    std::size_t offset = 0;
    bool isError = false;
    std::string text;
};

/// A parsed file: nodes in the order of the text, parents before children.
struct Tree {
    std::vector<Node> nodes;
    std::vector<Diagnostic> diagnostics;
    std::vector<Quantity> constants;  ///< of the kit
    bool wasParsed = false;

    [[nodiscard]] const Node& at(int index) const { return nodes[static_cast<std::size_t>(index)]; }
    /// The largest expression that a node is part of, within its statement.
    [[nodiscard]] int topOf(int index) const;
    /// The statement or declaration that a node stands in.
    [[nodiscard]] int statementOf(int index) const;
    /// The function or lambda that a node stands in; -1: none.
    [[nodiscard]] int functionOf(int index) const;
};

/// Parses C++ with libclang.
class Parser {
public:
    /// @param arguments  For Clang.
    explicit Parser(std::vector<std::string> arguments) : arguments_(std::move(arguments)) {}

    /// @param file  A name; it need not exist.
    [[nodiscard]] Tree parse(const std::string& file, const std::string& text) const;
    /// Writes a precompiled header. @return  False where that failed.
    [[nodiscard]] bool precompile(const std::string& header, const std::string& target) const;

private:
    std::vector<std::string> arguments_;
};

}  // namespace ticker::candidates

#endif
