#ifndef TICKER_TASKS_SUPPORT_TRAITS_H
#define TICKER_TASKS_SUPPORT_TRAITS_H

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace ticker::tasks {

/// Something that sets a question apart, in words: "a light nearer than 1".
template <class Asked>
struct Trait {
    const char* words;
    bool (*holds)(const Asked&);
    const char* hint = "";  ///< for a student whose code is wrong for such questions alone
};

/// What sets this question apart: "no point light, a black surface". May be empty.
template <class Asked>
[[nodiscard]] std::string wordsOf(std::type_identity_t<std::span<const Trait<Asked>>> traits,
                                  const Asked& asked) {
    std::string text;
    for (const Trait<Asked>& trait : traits)
        if (trait.holds(asked)) text += (text.empty() ? "" : ", ") + std::string{trait.words};
    return text;
}

/// Index of the wrong answer whose question has the fewest traits, to be shown as the example. At
/// least one answer must be wrong.
template <class Asked>
[[nodiscard]] std::size_t plainestWrong(std::type_identity_t<std::span<const Trait<Asked>>> traits,
                                        const std::vector<Asked>& asked,
                                        const std::vector<bool>& isWrong) {
    std::size_t best = 0;
    std::ptrdiff_t fewest = std::ssize(traits) + 1;
    for (std::size_t i = 0; i < asked.size(); ++i) {
        const auto count = std::ranges::count_if(
            traits, [&](const Trait<Asked>& trait) { return trait.holds(asked[i]); });
        if (!isWrong[i] || count >= fewest) continue;
        fewest = count;
        best = i;
    }
    return best;
}

/// The trait that all wrong answers have and the fewest right ones; null if at least a third of the
/// right ones have it, too, or if fewer than three answers are wrong.
template <class Asked>
[[nodiscard]] const Trait<Asked>* commonTrait(
    std::type_identity_t<std::span<const Trait<Asked>>> traits, const std::vector<Asked>& asked,
    const std::vector<bool>& isWrong) {
    std::size_t wrong = 0;
    for (const bool one : isWrong)
        wrong += one ? 1 : 0;
    const Trait<Asked>* best = nullptr;
    std::size_t fewest = (asked.size() - wrong) / 3 + 1;
    for (const Trait<Asked>& trait : traits) {
        std::size_t ofWrong = 0;
        std::size_t ofRight = 0;
        for (std::size_t i = 0; i < asked.size(); ++i)
            if (trait.holds(asked[i])) ++(isWrong[i] ? ofWrong : ofRight);
        if (wrong < 3 || ofWrong < wrong || ofRight >= fewest) continue;
        fewest = ofRight;
        best = &trait;
    }
    return best;
}

}  // namespace ticker::tasks

#endif
