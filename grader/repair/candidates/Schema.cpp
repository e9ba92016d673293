#include <grader/repair/candidates/Schema.h>

#include <map>

namespace ticker::candidates {
namespace {

constexpr const char* kBefore =
    "extern \"C\" unsigned char ticker_edit[];\n"
    "extern \"C\" void ticker_step();\n";

class Writer {
public:
    Writer(const Tree& tree, const Source& source, const std::vector<Atom>& atoms)
        : tree_(tree), source_(source), atoms_(atoms) {
        for (std::size_t i = 0; i < atoms.size(); ++i)
            if (!atoms[i].isApart)
                (atoms[i].isBefore    ? before_
                 : atoms[i].isInstead ? instead_
                                      : atSite_)[atoms[i].site]
                    .push_back(i);
    }

    Schema write() {
        schema_.text = kBefore;
        std::size_t at = 0;
        for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
            const Node& node = tree_.nodes[i];
            if (node.parent >= 0 || node.range.begin < at) continue;
            copy({at, node.range.begin});
            writeNode(static_cast<int>(i));
            at = node.range.end;
        }
        copy({at, source_.text().size()});
        return std::move(schema_);
    }

private:
    void copy(const Range& range) {
        if (range.begin < range.end) schema_.text += source_.in(range);
    }

    void writeNode(int index) {
        if (const auto before = before_.find(index); before != before_.end())
            for (const std::size_t atom : before->second) {
                const std::size_t begin = schema_.text.size();
                schema_.text += "if (ticker_edit[" + std::to_string(atom) + "]) {" +
                                atoms_[atom].edits.front().text + "}\n";
                schema_.places.push_back({atom, {begin, schema_.text.size()}});
            }
        if (const auto instead = instead_.find(index); instead != instead_.end())
            for (const std::size_t atom : instead->second) {
                const std::size_t begin = schema_.text.size();
                schema_.text += "if (ticker_edit[" + std::to_string(atom) + "]) {" +
                                atoms_[atom].edits.front().text + "} else ";
                schema_.places.push_back({atom, {begin, schema_.text.size()}});
            }
        const auto found = atSite_.find(index);
        if (found == atSite_.end()) return writeInner(index);
        schema_.text += "(";
        for (const std::size_t atom : found->second) {
            const std::size_t begin = schema_.text.size();
            const Range& range = tree_.at(index).range;
            schema_.text +=
                "ticker_edit[" + std::to_string(atom) + "]?(" +
                applied(std::string{source_.in(range)}, range.begin, atoms_[atom].edits) + "):";
            schema_.places.push_back({atom, {begin, schema_.text.size()}});
        }
        schema_.text += "(";
        writeInner(index);
        schema_.text += "))";
    }

    void writeInner(int index) {
        const Node& node = tree_.at(index);
        std::size_t at = node.range.begin;
        for (const int child : node.children) {
            const Range& range = tree_.at(child).range;
            if (range.begin < at || range.end > node.range.end) continue;
            copy({at, range.begin});
            const bool isBody = node.kind == NodeKind::loop && child == node.children.back() &&
                                !tree_.at(child).isExpression;
            // A loop that an edit makes endless is left by an exception.
            if (isBody) schema_.text += "{ticker_step();";
            writeNode(child);
            if (isBody && tree_.at(child).kind != NodeKind::block) schema_.text += ";";
            if (isBody) schema_.text += "}";
            at = range.end;
        }
        copy({at, node.range.end});
    }

    const Tree& tree_;
    const Source& source_;
    const std::vector<Atom>& atoms_;
    std::map<int, std::vector<std::size_t>> atSite_;
    std::map<int, std::vector<std::size_t>> before_;
    std::map<int, std::vector<std::size_t>> instead_;
    Schema schema_;
};

}  // namespace

Schema makeSchema(const Tree& tree, const Source& source, const std::vector<Atom>& atoms) {
    return Writer{tree, source, atoms}.write();
}

}  // namespace ticker::candidates
