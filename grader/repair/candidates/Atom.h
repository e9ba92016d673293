#ifndef TICKER_REPAIR_CANDIDATES_ATOM_H
#define TICKER_REPAIR_CANDIDATES_ATOM_H

#include <grader/repair/candidates/Tree.h>

#include <compare>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ticker::candidates {

struct Replacement {
    Range range;
    std::string text;

    [[nodiscard]] auto key() const { return std::make_pair(range.begin, std::string_view{text}); }
    // NOLINTNEXTLINE(modernize-use-nullptr): the compiler's own comparison with 0
    [[nodiscard]] auto operator<=>(const Replacement&) const = default;
};

/// One edit: what it replaces, and the expression that it is switched at.
struct Atom {
    std::string kind;
    std::vector<Replacement> edits;
    int site = -1;           ///< an expression or a statement; its text holds all that is replaced
    bool isApart = false;    ///< cannot be switched: has to be compiled by itself
    bool isBefore = false;   ///< a statement that is put in before the site
    bool isInstead = false;  ///< a statement in place of the site, which is one, too
};

/// An expression of the handout: its type, the type of the variable that `@` stands for (may be
/// empty), and its text.
struct HandoutFormula {
    std::string type;
    std::string of;
    std::string text;
};

/// A file with the edits that were found for it.
class Edits {
public:
    Edits(const Tree& tree, const Source& source, const std::vector<HandoutFormula>& formulas)
        : tree_(tree), source_(source), formulas_(formulas) {}

    [[nodiscard]] const Tree& tree() const { return tree_; }
    [[nodiscard]] const Source& source() const { return source_; }
    [[nodiscard]] const std::vector<HandoutFormula>& formulas() const { return formulas_; }
    [[nodiscard]] const std::vector<Atom>& atoms() const { return atoms_; }
    [[nodiscard]] std::string text(int node) const {
        return std::string{source_.in(tree_.at(node).range)};
    }
    /// The same without parentheses around all of it.
    [[nodiscard]] std::string bareText(int node) const;
    /// The same in parentheses, where an operator before or after it would tear it apart.
    [[nodiscard]] std::string operand(int node) const;
    [[nodiscard]] bool isType(int node, std::string_view type) const {
        return tree_.at(node).type == type;
    }
    [[nodiscard]] bool isNumber(int node) const {
        return isType(node, "double") || isInteger(node);
    }
    [[nodiscard]] bool isInteger(int node) const { return isType(node, "int"); }
    /// Whether it is of a class of the kit that can be added and scaled.
    [[nodiscard]] bool isVector(int node) const;

    void add(std::string kind, int site, std::vector<Replacement> edits);
    /// Replaces a node by a text, which gets parentheses where it needs them.
    /// @param isPrimary  The text holds together beside any operator.
    void replace(const std::string& kind, int node, const std::string& text, bool isPrimary);
    /// Replaces a node by another one's text.
    void replaceBy(const std::string& kind, int node, int other);
    void addApart(std::string kind, int site, std::vector<Replacement> edits);
    /// Puts a statement in before another one.
    void addBefore(std::string kind, int statement, const Range& place, const std::string& text);
    /// Puts a statement, or nothing, in place of another one.
    /// @param whole  Where that stands, with its semicolon.
    void addInstead(std::string kind, int statement, const Range& whole, const std::string& text);

private:
    void insert(Atom atom);

    const Tree& tree_;
    const Source& source_;
    const std::vector<HandoutFormula>& formulas_;
    std::vector<Atom> atoms_;
    std::set<std::vector<Replacement>> known_;
};

/// A statement with the semicolon behind it, which libclang leaves out.
[[nodiscard]] Range wholeOf(const Edits& edits, int statement);
/// The loop of the same function that a statement stands in; -1: none.
[[nodiscard]] int loopAround(const Tree& tree, int statement);

/// A text with replacements made in it. @param begin  Where the text begins in the file.
[[nodiscard]] std::string applied(std::string text, std::size_t begin,
                                  std::vector<Replacement> edits);

// Each adds the edits of one family at one node.
void addOperatorEdits(Edits& edits, int node);
void addNumberEdits(Edits& edits, int node);
void addNameEdits(Edits& edits, int node);
void addMemberEdits(Edits& edits, int node);
void addCallEdits(Edits& edits, int node);
void addWrapEdits(Edits& edits, int node);
void addTermEdits(Edits& edits, int node);
void addSiblingEdits(Edits& edits, int node);
void addStaticEdits(Edits& edits, int node);
void addStatementEdits(Edits& edits, int node);
void addConditionEdits(Edits& edits, int node);
void addDrawEdits(Edits& edits, int node);
void addGroupingEdits(Edits& edits, int node);
void addResets(Edits& edits, int node);
void addSecondRoots(Edits& edits, int node);
// These put in names that are visible in the function but not used.
void addWideEdits(Edits& edits, int node);
void addFormulas(Edits& edits, int node);
void addGuards(Edits& edits, int node);
void addNeighbours(Edits& edits, int node);

}  // namespace ticker::candidates

#endif
