#include <grader/repair/EditSets.h>

#include <grader/repair/EditCost.h>
#include <grader/repair/candidates/Tokens.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>

namespace ticker::repair {
namespace {

using candidates::tokensOf;

bool touch(const TextEdit& a, const TextEdit& b) {
    return a.begin <= b.end && b.begin <= a.end;
}

/// Whether two edits exclude each other: they change the same text, or the switch of one replaces
/// that of the other.
bool touch(const Atom& a, const Atom& b) {
    if (a.siteBegin < b.siteEnd && b.siteBegin < a.siteEnd) return true;
    return std::ranges::any_of(a.edits, [&](const TextEdit& one) {
        return std::ranges::any_of(b.edits,
                                   [&](const TextEdit& other) { return touch(one, other); });
    });
}

/// A text with every name replaced by "n". Statements of the same shape do the same with different
/// variables.
std::string shapeOf(std::string_view text) {
    std::string shape;
    for (const std::string_view word : candidates::wordsOf(text)) {
        const bool isName = std::isalpha(static_cast<unsigned char>(word.front())) != 0;
        shape += isName ? "n" : word;
        shape += ' ';
    }
    return shape;
}

bool isLight(const Atom& atom) {
    static const std::set<std::string> kKinds{"operator", "sign",     "drop",   "exchange",
                                              "name",     "number",   "member", "function",
                                              "unwrap",   "normalise"};
    return !atom.isApart && kKinds.contains(atom.kind);
}

/// Whether an edit changes the sign of a term or value.
bool isSign(std::string_view source, const Atom& atom) {
    if (atom.kind == "sign") return true;
    if (atom.kind != "operator" || atom.edits.size() != 1) return false;
    const TextEdit& edit = atom.edits.front();
    const std::string_view was = source.substr(edit.begin, edit.end - edit.begin);
    return (was == "+" && edit.text == "-") || (was == "-" && edit.text == "+");
}

/// Key of edits that correspond: kind, shape of the statement, and for each change its place in the
/// statement, in tokens, and the shape of the new text.
std::string placeOf(std::string_view source, const Atom& atom) {
    const std::string_view statement =
        source.substr(atom.statementBegin, atom.statementEnd - atom.statementBegin);
    std::string place = atom.kind + "|" + shapeOf(statement) + "|";
    for (const TextEdit& edit : atom.edits) {
        const std::string_view before =
            source.substr(atom.statementBegin, edit.begin - atom.statementBegin);
        place += std::to_string(tokensOf(before).size()) + ":" + shapeOf(edit.text) + ";";
    }
    return place;
}

std::string replacementOf(std::string_view source, const Atom& atom) {
    std::string text = atom.kind;
    for (const TextEdit& edit : atom.edits)
        text +=
            "|" + std::string{source.substr(edit.begin, edit.end - edit.begin)} + ">" + edit.text;
    return text;
}

/// Key of equal replacements within one statement.
std::string inStatement(std::string_view source, const Atom& atom) {
    return replacementOf(source, atom) + "|" + std::to_string(atom.statementBegin);
}

/// Key of replacements within one statement that differ in names only, such as in the components of
/// one colour.
std::string alikeInStatement(std::string_view source, const Atom& atom) {
    std::string text = "alike|" + atom.kind + "|" + std::to_string(atom.statementBegin);
    for (const TextEdit& edit : atom.edits)
        text += "|" + shapeOf(source.substr(edit.begin, edit.end - edit.begin)) + ">" +
                shapeOf(edit.text);
    return text;
}

/// Adds the whole group as one set, and every two and three of its edits. If some of its edits
/// exclude each other, only the pairs that do not are added. Nothing is added for a group of one or
/// of more than four.
void addGroup(const Candidates& candidates, const EditSet& group, std::set<EditSet>& sets) {
    constexpr std::size_t kMostPlaces = 4;
    if (group.size() < 2 || group.size() > kMostPlaces) return;
    bool isApart = true;
    for (std::size_t a = 0; a < group.size(); ++a)
        for (std::size_t b = a + 1; b < group.size(); ++b) {
            if (touch(candidates.atoms[group[a]], candidates.atoms[group[b]]))
                isApart = false;
            else
                sets.insert({group[a], group[b]});
        }
    if (!isApart) return;
    sets.insert(group);
    for (std::size_t without = 0; group.size() == kMostPlaces && without < kMostPlaces; ++without) {
        EditSet three = group;
        three.erase(three.begin() + static_cast<std::ptrdiff_t>(without));
        sets.insert(three);
    }
}

EditSet switched(const Candidates& candidates, const Choice& isChosen) {
    EditSet numbers;
    for (std::size_t i = 0; i < candidates.atoms.size(); ++i)
        if (!candidates.atoms[i].isApart && isChosen(candidates.atoms[i]))
            numbers.push_back(static_cast<std::uint16_t>(i));
    return numbers;
}

}  // namespace

std::vector<TextEdit> textEdits(const Candidates& candidates, const EditSet& set) {
    std::vector<TextEdit> edits;
    for (const std::uint16_t number : set) {
        const std::vector<TextEdit>& own = candidates.atoms[number].edits;
        edits.insert(edits.end(), own.begin(), own.end());
    }
    std::ranges::sort(edits, {}, &TextEdit::begin);
    return edits;
}

std::vector<EditSet> singles(std::string_view source, const Candidates& candidates,
                             const Choice& isChosen) {
    std::vector<EditSet> sets;
    for (const std::uint16_t number : switched(candidates, isChosen))
        sets.push_back({number});
    return simplestFirst(source, candidates, std::move(sets));
}

std::vector<EditSet> lightSingles(std::string_view source, const Candidates& candidates,
                                  const Choice& isChosen) {
    return singles(source, candidates,
                   [&](const Atom& atom) { return isLight(atom) && isChosen(atom); });
}

std::vector<EditSet> withoutSwitch(const Candidates& candidates, const Choice& isChosen) {
    std::vector<EditSet> sets;
    for (std::size_t i = 0; i < candidates.atoms.size(); ++i)
        if (candidates.atoms[i].isApart && isChosen(candidates.atoms[i]))
            sets.push_back({static_cast<std::uint16_t>(i)});
    return sets;
}

std::vector<EditSet> twins(std::string_view source, const Candidates& candidates,
                           const Choice& isChosen) {
    // Edits of these kinds are rare: all of a kind form one group, wherever they are.
    static const std::set<std::string> kAlike{"clamp", "draw", "regroup"};
    std::map<std::string, EditSet> groups;
    for (const std::uint16_t number : switched(candidates, isChosen)) {
        groups[replacementOf(source, candidates.atoms[number])].push_back(number);
        groups[placeOf(source, candidates.atoms[number])].push_back(number);
        groups[inStatement(source, candidates.atoms[number])].push_back(number);
        groups[alikeInStatement(source, candidates.atoms[number])].push_back(number);
        if (const std::string& kind = candidates.atoms[number].kind; kAlike.contains(kind))
            groups[kind].push_back(number);
    }
    std::set<EditSet> sets;
    for (const auto& [key, group] : groups)
        addGroup(candidates, group, sets);
    return simplestFirst(source, candidates, {sets.begin(), sets.end()}, true);
}

std::vector<EditSet> pairs(std::string_view source, const Candidates& candidates,
                           const Choice& isChosen) {
    std::map<std::size_t, EditSet> statements;
    for (const std::uint16_t number : switched(candidates, isChosen))
        if (isLight(candidates.atoms[number]))
            statements[candidates.atoms[number].statementBegin].push_back(number);
    std::vector<EditSet> sets;
    for (const auto& [begin, atoms] : statements)
        for (std::size_t a = 0; a < atoms.size(); ++a)
            for (std::size_t b = a + 1; b < atoms.size(); ++b)
                if (!touch(candidates.atoms[atoms[a]], candidates.atoms[atoms[b]]))
                    sets.push_back({atoms[a], atoms[b]});
    return simplestFirst(source, candidates, std::move(sets));
}

std::vector<EditSet> linked(std::string_view source, const Candidates& candidates,
                            const Choice& isChosen) {
    // Their pairs must leave time for the search for two mistakes.
    constexpr std::size_t kMost = 20;
    EditSet signs;
    EditSet leftOut;
    for (const std::uint16_t number : switched(candidates, isChosen)) {
        const Atom& atom = candidates.atoms[number];
        if (isSign(source, atom) && signs.size() < kMost) signs.push_back(number);
        if (atom.kind == "left-out" && leftOut.size() < kMost) leftOut.push_back(number);
    }
    std::vector<EditSet> sets;
    for (const EditSet& group : {leftOut, signs})
        for (std::size_t a = 0; a < group.size(); ++a)
            for (std::size_t b = a + 1; b < group.size(); ++b) {
                const Atom& one = candidates.atoms[group[a]];
                const Atom& other = candidates.atoms[group[b]];
                if (one.statementBegin != other.statementBegin && !touch(one, other))
                    sets.push_back({group[a], group[b]});
            }
    return simplestFirst(source, candidates, std::move(sets), true);
}

std::vector<EditSet> together(const Candidates& candidates, const EditSet& set,
                              std::span<const EditSet> others) {
    std::vector<EditSet> sets;
    for (const EditSet& other : others) {
        const bool doTouch = std::ranges::any_of(set, [&](std::uint16_t one) {
            return std::ranges::any_of(other, [&](std::uint16_t two) {
                return touch(candidates.atoms[one], candidates.atoms[two]);
            });
        });
        if (doTouch) continue;
        sets.push_back(set);
        sets.back().insert(sets.back().end(), other.begin(), other.end());
    }
    return sets;
}

}  // namespace ticker::repair
