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

class Fitting {
public:
    Fitting(const Tree& tree, std::vector<Atom>& atoms) : tree_(tree), atoms_(atoms) {}

    /// Judges a schema. @return  Whether something had to change.
    bool judge(const Schema& schema, const Tree& parsed) {
        std::set<std::size_t> wrong;
        std::set<std::size_t> other;
        for (const Diagnostic& said : parsed.diagnostics) {
            if (!said.isError) continue;
            if (const auto atom = atomAt(schema, said.offset)) {
                const bool isAtSwitch = said.text.find("incompatible operand types") == 0 ||
                                        said.text.find("conditional expression") == 0;
                (isAtSwitch ? other : wrong).insert(*atom);
            } else {
                blame(schema, said.offset, wrong);
            }
        }
        compareTypes(schema, parsed, other);
        for (const std::size_t atom : wrong)
            atoms_[atom].edits.clear();
        for (const std::size_t atom : other)
            if (!wrong.contains(atom)) lift(atoms_[atom]);
        return !wrong.empty() || !other.empty();
    }

private:
    /// Marks the edits that may cause an error outside of all switches: those in the same line. If
    /// some of them are of a kind that may change a type, only these.
    void blame(const Schema& schema, std::size_t offset, std::set<std::size_t>& wrong) const {
        const std::size_t begin = schema.text.rfind('\n', offset);
        const std::size_t end = schema.text.find('\n', offset);
        std::set<std::size_t> risky;
        std::set<std::size_t> any;
        for (const Schema::Place& place : schema.places) {
            if (begin != std::string::npos && place.range.end <= begin) continue;
            if (place.range.begin >= end) continue;
            any.insert(place.atom);
            if (isRisky(atoms_[place.atom].kind)) risky.insert(place.atom);
        }
        wrong.merge(risky.empty() ? any : risky);
    }

    void compareTypes(const Schema& schema, const Tree& parsed, std::set<std::size_t>& other) {
        constexpr std::string_view kSwitch = "ticker_edit[";
        for (const Node& node : parsed.nodes) {
            if (node.kind != NodeKind::expression || node.children.size() != 3) continue;
            const std::string_view text =
                std::string_view{schema.text}.substr(node.range.begin, node.range.size());
            if (!text.starts_with(kSwitch)) continue;
            const auto atom =
                static_cast<std::size_t>(std::stoul(std::string{text.substr(kSwitch.size(), 8)}));
            const int site = atoms_[atom].site;
            const std::string& was = tree_.at(site).type;
            const std::string& is = parsed.at(node.children[1]).type;
            const bool fits =
                was == is || (isConverted(tree_, site) && isArithmetic(was) && isArithmetic(is));
            if (!fits) other.insert(atom);
        }
    }

    /// Moves an edit's switch up to the whole expression, whose value is converted. An edit whose
    /// switch is there already has to be compiled by itself.
    void lift(Atom& atom) {
        const int top = tree_.topOf(atom.site);
        if (top == atom.site)
            atom.isApart = true;
        else
            atom.site = top;
    }

    const Tree& tree_;
    std::vector<Atom>& atoms_;
};

}  // namespace

Schema fitSchema(const Parser& parser, const std::string& file, const Tree& tree,
                 const Source& source, std::vector<Atom>& atoms) {
    constexpr int kMostRounds = 8;
    for (int round = 0; round < kMostRounds; ++round) {
        const Schema schema = makeSchema(tree, source, atoms);
        const Tree parsed = parser.parse(file, schema.text);
        if (!Fitting{tree, atoms}.judge(schema, parsed)) return schema;
        std::erase_if(atoms, [](const Atom& atom) { return atom.edits.empty(); });
    }
    atoms.clear();
    return makeSchema(tree, source, atoms);
}

}  // namespace ticker::candidates
