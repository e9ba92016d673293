#include <grader/repair/EditCost.h>

#include <grader/repair/EditSets.h>
#include <grader/repair/candidates/Tokens.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace ticker::repair {
namespace {

using candidates::wordsOf;

/// Words of a text that count as changed. Signs that belong to a word beside them do not:
/// `.normalised()` is one word.
std::vector<std::string_view> weighedWordsOf(std::string_view text) {
    static const std::set<std::string_view> kLight{"(", ")", "{", "}", ".", "->", "::", ",", "std"};
    std::vector<std::string_view> words = wordsOf(text);
    std::erase_if(words, [](std::string_view word) { return kLight.contains(word); });
    return words;
}

/// Words of the longer list between what both share at their beginnings and ends.
std::size_t differing(const std::vector<std::string_view>& a,
                      const std::vector<std::string_view>& b) {
    std::size_t front = 0;
    while (front < a.size() && front < b.size() && a[front] == b[front])
        ++front;
    std::size_t back = 0;
    while (back + front < a.size() && back + front < b.size() &&
           a[a.size() - 1 - back] == b[b.size() - 1 - back])
        ++back;
    return std::max(a.size(), b.size()) - front - back;
}

// The rank of kinds that add something beside what was there.
constexpr std::size_t kLastRank = 4;

/// Order of kinds among edits that change the same number of tokens, lowest first. Kinds that
/// remove something come first, and kinds that add more come later.
std::size_t rankOf(const Atom& atom) {
    static const std::map<std::string, std::size_t> kRanks{
        {"operator", 1}, {"function", 1}, {"member", 1},   {"drop", 0},     {"left-out", 0},
        {"unwrap", 1},   {"number", 2},   {"exchange", 2}, {"sign", 2},     {"normalise", 2},
        {"name", 3},     {"jump", 3},     {"argument", 0}, {"threshold", 0}};
    const auto found = kRanks.find(atom.kind);
    return found == kRanks.end() ? kLastRank : found->second;
}

/// Whether an edit makes the text longer.
bool putsIn(std::string_view source, const Atom& atom) {
    std::size_t before = 0;
    std::size_t after = 0;
    for (const TextEdit& edit : atom.edits) {
        before += weighedWordsOf(source.substr(edit.begin, edit.end - edit.begin)).size();
        after += weighedWordsOf(edit.text).size();
    }
    return after > before;
}

/// Whether an edit counts as one token, however many it changes: it is one idea in many words, and
/// a file has few such edits.
bool isOneThought(std::string_view source, const Atom& atom, bool isAtSeveralPlaces) {
    // An if is left out with all that depends on it.
    if (atom.kind == "left-out" && source.substr(atom.edits.front().begin).starts_with("if"))
        return true;
    return atom.kind == "drop" || atom.kind == "draw" || atom.kind == "jump" ||
           atom.kind == "limit" || atom.kind == "argument" || atom.kind == "root" ||
           (isAtSeveralPlaces && atom.kind == "left-out");
}

/// Bytes of the text that an edit adds something to. If the same words can be added in several
/// places, the smallest place is the most exact one. 0 for all other kinds, such as signs and
/// names: they keep the order of the text, so that the place that defines a quantity comes before
/// those that use it.
std::size_t placeSize(const Atom& atom) {
    if (rankOf(atom) < kLastRank) return 0;
    std::size_t size = 0;
    for (const TextEdit& edit : atom.edits)
        size += edit.end - edit.begin;
    return size;
}

}  // namespace

std::size_t tokensChanged(std::string_view source, const Candidates& candidates,
                          const EditSet& set) {
    std::size_t count = 0;
    for (const TextEdit& edit : textEdits(candidates, set))
        count += differing(weighedWordsOf(source.substr(edit.begin, edit.end - edit.begin)),
                           weighedWordsOf(edit.text));
    return count;
}

std::vector<EditSet> simplestFirst(std::string_view source, const Candidates& candidates,
                                   std::vector<EditSet> sets, bool isOne) {
    constexpr std::size_t kRanks = 10;
    std::vector<std::size_t> costOf;
    for (std::size_t i = 0; i < candidates.atoms.size(); ++i) {
        const Atom& atom = candidates.atoms[i];
        const std::size_t tokens =
            isOneThought(source, atom, isOne)
                ? 1
                : tokensChanged(source, candidates, {static_cast<std::uint16_t>(i)});
        costOf.push_back(kRanks * tokens + 2 * rankOf(atom) + (putsIn(source, atom) ? 1 : 0));
    }
    using Rank = std::pair<std::size_t, std::size_t>;
    std::vector<std::pair<Rank, EditSet>> ranked;
    for (EditSet& set : sets) {
        std::size_t tokens = 0;
        std::size_t place = 0;
        for (const std::uint16_t number : set) {
            tokens = isOne ? std::max(tokens, costOf[number]) : tokens + costOf[number];
            place += placeSize(candidates.atoms[number]);
        }
        ranked.emplace_back(Rank{tokens, place}, std::move(set));
    }
    std::ranges::stable_sort(ranked, {}, &std::pair<Rank, EditSet>::first);
    sets.clear();
    for (auto& [rank, set] : ranked)
        sets.push_back(std::move(set));
    return sets;
}

}  // namespace ticker::repair
