// Finds edits of a student's file. Runs in the sandbox, since the file is untrusted.
//   ticker-candidates --precompile HEADER TARGET CLANG-ARGUMENT...
//   ticker-candidates SOURCE STUB PRODUCT simple|wide FUNCTION,... FORMULAS CLANG-ARGUMENT...
// writes the edits and the program that carries them as JSON, as ../Candidates.cpp reads it. What
// stands in the stub as well is not the student's and is left alone, and so are these functions.
// FORMULAS has a line for each: its type, the type of its variable, and its text, with tabs
// between.
#include <grader/repair/candidates/Atom.h>
#include <grader/repair/candidates/Schema.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <set>
#include <span>
#include <sstream>

namespace {

using namespace ticker::candidates;

std::string quoted(const std::string& text) {
    static constexpr const char* kDigits = "0123456789abcdef";
    std::string json = "\"";
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            json += std::string{'\\', c};
        else if (c == '\n')
            json += "\\n";
        else if (code < 0x20)
            json += std::string{"\\u00"} + kDigits[code >> 4U] + kDigits[code & 15U];
        else
            json += c;
    }
    return json + "\"";
}

/// Tokens with one blank between them.
std::string normal(const Source& source, const Range& range) {
    std::string text = " ";
    for (const Range& token : source.tokensIn(range))
        text += std::string{source.in(token)} + " ";
    return text;
}

std::size_t countOf(std::string_view text, std::string_view part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string_view::npos;
         at = text.find(part, at + 1))
        ++count;
    return count;
}

/// The outermost function that a node stands in.
std::string functionAround(const Tree& tree, int index) {
    std::string name;
    for (int at = tree.functionOf(index); at >= 0; at = tree.functionOf(at))
        name = tree.at(at).name;
    return name;
}

std::string asJson(const Tree& tree, const std::vector<Atom>& atoms, const Schema& schema) {
    std::ostringstream out;
    out << "{\"program\": " << quoted(schema.text) << ",\n\"atoms\": [";
    for (std::size_t i = 0; i < atoms.size(); ++i) {
        const Atom& atom = atoms[i];
        const Range& statement = tree.at(tree.statementOf(atom.site)).range;
        // What is put in before a statement leaves the switches in it alone.
        const Range& site = tree.at(atom.site).range;
        const std::size_t siteEnd = atom.isBefore ? site.begin : site.end;
        out << (i == 0 ? "\n" : ",\n") << "{\"kind\": " << quoted(atom.kind) << ", \"statement\": ["
            << statement.begin << ", " << statement.end << "], \"site\": [" << site.begin << ", "
            << siteEnd << "], \"function\": " << quoted(functionAround(tree, atom.site))
            << ", \"apart\": " << (atom.isApart ? "true" : "false") << ", \"edits\": [";
        for (std::size_t e = 0; e < atom.edits.size(); ++e) {
            const Replacement& edit = atom.edits[e];
            out << (e == 0 ? "" : ", ") << "[" << edit.range.begin << ", " << edit.range.end << ", "
                << quoted(edit.text) << "]";
        }
        out << "]}";
    }
    const bool keepsState = std::any_of(tree.nodes.begin(), tree.nodes.end(), [](const Node& node) {
        return node.kind == NodeKind::declaration && node.isStatic && !node.isConstant;
    });
    out << "],\n\"keepsState\": " << (keepsState ? "true" : "false") << "}\n";
    return out.str();
}

using AddEdits = void (*)(Edits&, int);

constexpr AddEdits kSimple[] = {
    addOperatorEdits,  addNumberEdits, addNameEdits,     addMemberEdits, addCallEdits,
    addWrapEdits,      addTermEdits,   addSiblingEdits,  addStaticEdits, addStatementEdits,
    addConditionEdits, addDrawEdits,   addGroupingEdits, addResets,      addSecondRoots};
constexpr AddEdits kWide[] = {addFormulas, addGuards, addNeighbours, addWideEdits};

/// What is looked for, apart from the file.
struct Wanted {
    bool isWide = false;
    std::set<std::string> leftAlone;
    std::vector<HandoutFormula> formulas;
};

std::vector<Atom> findAtoms(const Tree& tree, const Source& source, const Source& stub,
                            const Wanted& wanted) {
    constexpr std::size_t kMost = 2400;
    const std::string given = normal(stub, {0, stub.text().size()});
    const std::string all = normal(source, {0, source.text().size()});
    const auto kinds = wanted.isWide ? std::span<const AddEdits>{kWide} : kSimple;
    Edits edits{tree, source, wanted.formulas};
    for (int i = 0; i < static_cast<int>(tree.nodes.size()); ++i) {
        const Node& node = tree.at(i);
        if (!node.isWritten || tree.functionOf(i) < 0 || edits.atoms().size() > kMost) continue;
        // What stands in the file more often than in the stub is the student's, too.
        const std::string statement = normal(source, tree.at(tree.statementOf(i)).range);
        const std::size_t givenTimes = countOf(given, statement);
        if (givenTimes > 0 && countOf(all, statement) <= givenTimes) continue;
        if (wanted.leftAlone.contains(functionAround(tree, i))) continue;
        for (const AddEdits add : kinds)
            add(edits, i);
    }
    return edits.atoms();
}

std::set<std::string> namesIn(const std::string& list) {
    std::set<std::string> names;
    std::istringstream stream{list};
    for (std::string name; std::getline(stream, name, ',');)
        names.insert(name);
    return names;
}

std::vector<HandoutFormula> formulasIn(const std::string& lines) {
    std::vector<HandoutFormula> formulas;
    std::istringstream stream{lines};
    HandoutFormula one;
    while (std::getline(stream, one.type, '\t') && std::getline(stream, one.of, '\t') &&
           std::getline(stream, one.text))
        formulas.push_back(one);
    return formulas;
}

std::string contentsOf(const std::string& file) {
    std::ifstream stream{file, std::ios::binary};
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

int explain(const std::string& file, const std::string& stub, const std::string& product,
            const Wanted& wanted, const Parser& parser) {
    const Source source{contentsOf(file)};
    const Tree tree = parser.parse(file, source.text());
    if (!tree.wasParsed) return 2;
    std::vector<Atom> atoms = findAtoms(tree, source, Source{contentsOf(stub)}, wanted);
    const Schema schema = fitSchema(parser, file, tree, source, atoms);
    std::ofstream out{product, std::ios::binary};
    out << asJson(tree, atoms, schema);
    return out.flush() ? 0 : 2;
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words{argv + 1, argv + argc};
    if (words.size() >= 3 && words[0] == "--precompile")
        return Parser{{words.begin() + 3, words.end()}}.precompile(words[1], words[2]) ? 0 : 1;
    if (words.size() >= 6)
        return explain(words[0], words[1], words[2],
                       {words[3] == "wide", namesIn(words[4]), formulasIn(words[5])},
                       Parser{{words.begin() + 6, words.end()}});
    std::cerr << "ticker-candidates: SOURCE STUB PRODUCT simple|wide FUNCTION,... FORMULAS "
                 "CLANG-ARGUMENT...\n";
    return 2;
}
