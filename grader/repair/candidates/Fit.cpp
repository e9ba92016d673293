#include <grader/repair/candidates/Schema.h>

#include <algorithm>
#include <optional>
#include <set>

namespace ticker::candidates {
namespace {

bool isArithmetic(const std::string& type) {
    static const std::set<std::string> kTypes{"int",   "unsigned int", "long",  "unsigned long",
                                              "float", "double",       "short", "bool"};
    return kTypes.contains(type);
}

/// The innermost switch that holds an offset of the schema.
std::optional<std::size_t> atomAt(const Schema& schema, std::size_t offset) {
    const Schema::Place* found = nullptr;
    for (const Schema::Place& place : schema.places)
        if (place.range.begin <= offset && offset < place.range.end &&
            (found == nullptr || place.range.size() < found->range.size()))
            found = &place;
    if (found == nullptr) return std::nullopt;
    return found->atom;
}

/// Whether the value of an expression is converted to a type that does not depend on it.
bool isConverted(const Tree& tree, int site) {
    const int parent = tree.at(site).parent;
    if (parent < 0) return false;
    const Node& around = tree.at(parent);
    if (around.kind == NodeKind::declaration) return !around.isAuto;
    return around.kind == NodeKind::statement || around.kind == NodeKind::jump ||
           around.kind == NodeKind::branch;
}

/// Whether edits of a kind may have another type than what they replace.
bool isRisky(const std::string& kind) {
    static const std::set<std::string> kKinds{"cast",  "function", "clamp", "bound",    "unwrap",
                                              "limit", "word",     "guard", "normalise"};
    return kKinds.contains(kind);
}

/// Edits whose switches do not compile.
struct Unfit {
    std::set<std::size_t> wrong;      ///< no type allows the edited text
    std::set<std::size_t> otherType;  ///< the edited text has another type than what was handed in
};

/// The edits that may cause an error outside of all switches: those in the same line. If some of
/// them are of a kind that may change a type, only these.
std::set<std::size_t> suspects(const Schema& schema, const std::vector<Atom>& atoms,
                               std::size_t offset) {
    const std::size_t begin = schema.text.rfind('\n', offset);
    const std::size_t end = schema.text.find('\n', offset);
    std::set<std::size_t> risky;
    std::set<std::size_t> any;
    for (const Schema::Place& place : schema.places) {
        if (begin != std::string::npos && place.range.end <= begin) continue;
        if (place.range.begin >= end) continue;
        any.insert(place.atom);
        if (isRisky(atoms[place.atom].kind)) risky.insert(place.atom);
    }
    return risky.empty() ? any : risky;
}

/// The edit of a switch, `ticker_edit[NUMBER]?(edited):(...)`.
std::optional<std::size_t> atomOfSwitch(const Schema& schema, const Node& node) {
    constexpr std::string_view kBegin = "ticker_edit[";
    constexpr std::size_t kMostDigits = 8;
    if (node.kind != NodeKind::expression || node.children.size() != 3) return std::nullopt;
    const std::string_view text =
        std::string_view{schema.text}.substr(node.range.begin, node.range.size());
    if (!text.starts_with(kBegin)) return std::nullopt;
    return std::stoul(std::string{text.substr(kBegin.size(), kMostDigits)});
}

/// Whether an edited text of a type may stand where an expression was.
bool fits(const std::string& type, const Tree& tree, int site) {
    const std::string& was = tree.at(site).type;
    return type == was || (isConverted(tree, site) && isArithmetic(was) && isArithmetic(type));
}

/// @param parsed  The schema's text.
Unfit unfitOf(const Schema& schema, const Tree& parsed, const Tree& tree,
              const std::vector<Atom>& atoms) {
    Unfit unfit;
    for (const Diagnostic& said : parsed.diagnostics) {
        if (!said.isError) continue;
        const auto atom = atomAt(schema, said.offset);
        if (!atom)
            unfit.wrong.merge(suspects(schema, atoms, said.offset));
        else if (said.text.starts_with("incompatible operand types") ||
                 said.text.starts_with("conditional expression"))
            unfit.otherType.insert(*atom);
        else
            unfit.wrong.insert(*atom);
    }
    for (const Node& node : parsed.nodes)
        if (const auto atom = atomOfSwitch(schema, node))
            if (!fits(parsed.at(node.children[1]).type, tree, atoms[*atom].site))
                unfit.otherType.insert(*atom);
    return unfit;
}

/// Moves an edit's switch up to the whole expression, whose value is converted. An edit whose
/// switch is there already has to be compiled by itself.
void lift(Atom& atom, const Tree& tree) {
    const int top = tree.topOf(atom.site);
    if (top == atom.site)
        atom.isApart = true;
    else
        atom.site = top;
}

}  // namespace

Schema fitSchema(const Parser& parser, const std::string& file, const Tree& tree,
                 const Source& source, std::vector<Atom>& atoms) {
    constexpr int kMostRounds = 8;
    for (int round = 0; round < kMostRounds; ++round) {
        const Schema schema = makeSchema(tree, source, atoms);
        const Tree parsed = parser.parse(file, schema.text);
        const Unfit unfit = unfitOf(schema, parsed, tree, atoms);
        if (unfit.wrong.empty() && unfit.otherType.empty()) return schema;
        for (const std::size_t atom : unfit.otherType)
            lift(atoms[atom], tree);
        for (const std::size_t atom : unfit.wrong)
            atoms[atom].edits.clear();
        std::erase_if(atoms, [](const Atom& atom) { return atom.edits.empty(); });
    }
    atoms.clear();
    return makeSchema(tree, source, atoms);
}

}  // namespace ticker::candidates
